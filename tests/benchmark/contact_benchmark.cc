// One wheel for one time step: how its parts share the time. The wheel stands in its own rut.
#include <benchmark/benchmark.h>

#include <variant>

#include "contact/equilibrium.h"
#include "contact/mesh_contact.h"
#include "contact/mesh_sinkage.h"
#include "contact/plastic_sinkage.h"
#include "tests/benchmark/mesh_wheels.h"

namespace softsoil {
namespace {

struct Standing {
  Standing(const Tire& its_tire, double grid_spacing)
      : tire(its_tire), wheel(ContactOf(tire, grid_spacing)) {
    surface = std::make_unique<Surface>(grid_spacing, SurfaceMode::kFlow, Level);
    pose = PressedIn(tire, 0.08);
    pose.velocity_w = {1, 0, 0};
    pose.angular_velocity_w = {0, 1.1 / tire.shape.radius, 0};
    for (int k = 0; k < 3; ++k) {
      Evaluate();
      Sink();
      for (const NodeSinkage& s : sinkage) surface->DeepenPlastic(s);
    }
  }

  using Contact = std::variant<WheelContact, MeshContact>;
  static Contact ContactOf(const Tire& tire, double spacing) {
    if (tire.mesh != nullptr) return MeshContact(tire, spacing);
    return WheelContact(tire, spacing);
  }

  void Evaluate() {
    std::visit([this](auto& w) { w.Evaluate(pose, *surface, soils, 0.001, &forces); }, wheel);
  }
  void Commit() {
    std::visit([this](auto& w) { w.Commit(forces); }, wheel);
  }
  void Sink() {
    const auto sink = tire.mesh != nullptr ? PlasticSinkageOfMesh : PlasticSinkage;
    sink(tire, pose, forces.patch, soils, &sinkage);
  }

  Tire tire;
  SoilMap soils = TilledLoam();
  Contact wheel;
  std::unique_ptr<Surface> surface;
  TirePose pose;
  PatchForces forces;
  std::vector<NodeSinkage> sinkage;
};

const Tire kTires[] = {TruckTire(), AgriculturalTire(), TireNamed("18.4R38_85kPa_lugged"),
                       MeshWheel(false), MeshWheel(true)};

Standing Wheel(const benchmark::State& state) {
  return Standing(kTires[state.range(0)], state.range(1) * 1e-3);
}

void PerNode(benchmark::State& state, const Standing& wheel) {
  state.SetLabel(wheel.tire.name);
  state.counters["contacts"] = static_cast<double>(wheel.forces.contacts.size());
  state.counters["per_contact"] = benchmark::Counter(
      wheel.forces.contacts.size(),
      benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void BM_Evaluate(benchmark::State& state) {
  Standing w = Wheel(state);
  for (auto _ : state) w.Evaluate();
  PerNode(state, w);
}

void BM_Commit(benchmark::State& state) {
  Standing w = Wheel(state);
  for (auto _ : state) w.Commit();
  PerNode(state, w);
}

void BM_PlasticSinkage(benchmark::State& state) {
  Standing w = Wheel(state);
  for (auto _ : state) w.Sink();
  PerNode(state, w);
}

void BM_CopyPatch(benchmark::State& state) {
  Standing w = Wheel(state);
  SurfacePatch patch;
  const double r = w.tire.shape.radius, b = w.tire.shape.width / 2;
  for (auto _ : state) w.surface->CopyPatch(-r, r, -b, b, &patch);
  PerNode(state, w);
}

void BM_GatherLoad(benchmark::State& state) {
  Standing w = Wheel(state);
  LoadGatherer gatherer(w.surface->spacing());
  for (auto _ : state) {
    for (const SurfaceForce& force : w.forces.surface) gatherer.Add(force, 0.001);
  }
  PerNode(state, w);
}

void Wheels(benchmark::internal::Benchmark* b) {
  b->ArgNames({"tire", "grid_mm"});
  for (int tire : {0, 1, 2, 3, 4}) {
    for (int grid : {25, 50}) b->Args({tire, grid});
  }
  b->Unit(benchmark::kMicrosecond);
}
BENCHMARK(BM_Evaluate)->Apply(Wheels);
BENCHMARK(BM_Commit)->Apply(Wheels);
BENCHMARK(BM_PlasticSinkage)->Apply(Wheels);
BENCHMARK(BM_CopyPatch)->Apply(Wheels);
BENCHMARK(BM_GatherLoad)->Apply(Wheels);

void BM_Equilibrium(benchmark::State& state) {
  TireSpring spring;
  spring.root = 3.469e5;
  PressedPoint point{0.1, state.range(0) * 1e-3, 1, 0.9};
  for (auto _ : state) {
    benchmark::DoNotOptimize(point);
    benchmark::DoNotOptimize(Equilibrium(spring, PlateCurve{1.15e6, 0.85, {}}, point));
  }
}
BENCHMARK(BM_Equilibrium)->ArgName("depth_mm")->Arg(0)->Arg(40)->Arg(200);

}  // namespace
}  // namespace softsoil
