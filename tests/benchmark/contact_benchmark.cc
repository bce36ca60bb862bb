// One wheel for one time step: how its parts share the time. The wheel stands in its own rut.
#include <benchmark/benchmark.h>

#include "contact/equilibrium.h"
#include "contact/plastic_sinkage.h"
#include "contact/soft_wheels.h"

namespace softsoil {
namespace {

struct Standing {
  Standing(const char* tire_name, double grid_spacing) {
    Catalogue<Tire> tires = TireCatalogue();
    tires.AddFolder(SOFTSOIL_SOURCE_DIR "/models/tires");
    Catalogue<Soil> catalogue = SoilCatalogue();
    catalogue.AddFolder(SOFTSOIL_SOURCE_DIR "/models/soils");
    tire = tires.Find(tire_name);
    soil = catalogue.Find("tilled_yolo_loam");
    soils = soil;
    wheel = std::make_unique<WheelContact>(tire, grid_spacing);
    surface = std::make_unique<Surface>(grid_spacing, SurfaceMode::kFlow,
                                        [](double, double) { return 0.0; });
    pose.centre_w = {0, 0, tire.shape.radius - 0.08};
    pose.frame_w.setIdentity();
    pose.velocity_w = {1, 0, 0};
    pose.angular_velocity_w = {0, 1.1 / tire.shape.radius, 0};
    for (int k = 0; k < 3; ++k) {
      wheel->Evaluate(pose, *surface, soils, 0.001, &forces);
      PlasticSinkage(tire, pose, forces.patch, soils, &sinkage);
      for (const NodeSinkage& s : sinkage) surface->DeepenPlastic(s);
    }
  }
  Tire tire;
  Soil soil;
  SoilMap soils;
  TirePose pose;
  std::unique_ptr<WheelContact> wheel;
  std::unique_ptr<Surface> surface;
  PatchForces forces;
  std::vector<NodeSinkage> sinkage;
};

constexpr const char* kTires[] = {"37x12.5R16.5_15psi", "18.4R38_85kPa"};

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
  for (auto _ : state) w.wheel->Evaluate(w.pose, *w.surface, w.soils, 0.001, &w.forces);
  PerNode(state, w);
}

void BM_Commit(benchmark::State& state) {
  Standing w = Wheel(state);
  for (auto _ : state) w.wheel->Commit(w.forces);
  PerNode(state, w);
}

void BM_PlasticSinkage(benchmark::State& state) {
  Standing w = Wheel(state);
  for (auto _ : state) PlasticSinkage(w.tire, w.pose, w.forces.patch, w.soils, &w.sinkage);
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
  for (int tire : {0, 1}) {
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
