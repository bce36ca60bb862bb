// Four wheels of a HMMWV rolling on tilled loam: one time step of 1 ms, and one tick of the soil
// clock, as shares of the simulated time that they take up.
#include <benchmark/benchmark.h>

#include <cmath>

#include "contact/soft_wheels.h"
#include "tests/benchmark/threads.h"

namespace softsoil {
namespace {

constexpr double kStep = 0.001, kSpeed = 3;  // [s], [m/s]
constexpr double kSunk = 0.08;               // [m]  about 6 kN per wheel

struct Vehicle {
  explicit Vehicle(int threads) : poses(4), forces(4) {
    Catalogue<Tire> tires = TireCatalogue();
    tires.AddFolder(SOFTSOIL_SOURCE_DIR "/models/tires");
    Catalogue<Soil> soils = SoilCatalogue();
    soils.AddFolder(SOFTSOIL_SOURCE_DIR "/models/soils");
    const Tire tire = tires.Find("37x12.5R16.5_15psi");
    GroundSettings settings;
    settings.sync = true;
    settings.threads = threads;
    wheels = std::make_unique<SoftWheels>(
        soils.Find("tilled_yolo_loam"), settings, [](double, double) { return 0.0; },
        std::vector<Tire>(4, tire));
    for (int w = 0; w < 4; ++w) {
      poses[w].centre_w = {3.3 * (w / 2), 1.82 * (w % 2), tire.shape.radius - kSunk};
      poses[w].velocity_w = {kSpeed, 0, 0};
      poses[w].angular_velocity_w = {0, 1.1 * kSpeed / tire.shape.radius, 0};
    }
  }
  void Evaluate() {
    for (int w = 0; w < 4; ++w) {
      const double turned = poses[w].angular_velocity_w.y() * kStep * step;
      poses[w].frame_w = Eigen::AngleAxisd(turned, Eigen::Vector3d::UnitY()).toRotationMatrix();
      poses[w].centre_w.x() += kSpeed * kStep;
      wheels->Evaluate(w, poses[w], kStep, &forces[w]);
    }
    ++step;
  }
  void Commit() { wheels->Commit(poses, forces, kStep); }

  std::unique_ptr<SoftWheels> wheels;
  std::vector<TirePose> poses;
  std::vector<PatchForces> forces;
  int step = 0;
};

// All of a soil period but the forces: ten steps, the tenth with the tick.
void BM_Step(benchmark::State& state) {
  Vehicle vehicle(static_cast<int>(state.range(0)));
  const bool commits = state.range(1) != 0;
  for (auto _ : state) {
    for (int k = 0; k < 10; ++k) {
      vehicle.Evaluate();
      if (commits) vehicle.Commit();
    }
  }
  state.SetLabel(commits ? "with soil" : "forces only");
  state.counters["real_time_factor"] = benchmark::Counter(
      10 * kStep, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
  state.counters["columns"] = static_cast<double>(vehicle.wheels->ground().ColumnCount());
}
BENCHMARK(BM_Step)
    ->ArgNames({"threads", "soil"})
    ->Args({1, 0})
    ->Args({1, 1})
    ->Args({2, 1})
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond)
    ->Iterations(100);

// A tick alone, under the standing load of four wheels.
void BM_SoilTick(benchmark::State& state) {
  Vehicle vehicle(static_cast<int>(state.range(0)));
  vehicle.Evaluate();
  Ground& ground = vehicle.wheels->ground();
  const double period = ground.settings().soil_clock;
  for (auto _ : state) {
    for (int w = 0; w < 4; ++w) ground.AddLoad(w, vehicle.forces[w].surface, period);
    ground.Pass(period);
  }
  state.counters["volumes"] = static_cast<double>(ground.VolumeCount());
}
BENCHMARK(BM_SoilTick)->Apply(OnOneAndTwoThreads);

}  // namespace
}  // namespace softsoil
