// One time step of a wheel that drives in the soil bin, contact and ground together: what flow,
// lugs and meshes cost beside a smooth tire on ground that does not flow.
#include <benchmark/benchmark.h>

#include "tests/benchmark/mesh_wheels.h"
#include "tests/contact/soil_bin.h"

namespace softsoil {
namespace {

void BM_Step(benchmark::State& state, const Tire& tire, SurfaceMode mode) {
  SoilBinSettings settings;
  settings.tire = tire;
  settings.mode = mode;
  settings.grid_spacing = 0.025;
  settings.step = 0.001;
  SoilBin bin(settings);
  bin.Drive(0.3, 0, 0);
  bin.Drive(0.2, 1, 0.2);
  for (auto _ : state) bin.Step();
  state.counters["contacts"] = static_cast<double>(bin.forces().contacts.size());
}

// The soil update, which the step waits for, is done by another thread: its time counts too.
void Settings(benchmark::internal::Benchmark* b) {
  b->Unit(benchmark::kMicrosecond)->MeasureProcessCPUTime();
}
const Tire kSmooth = AgriculturalTire(), kLugged = TireNamed("18.4R38_85kPa_lugged");
BENCHMARK_CAPTURE(BM_Step, smooth_no_flow, kSmooth, SurfaceMode::kCompaction)->Apply(Settings);
BENCHMARK_CAPTURE(BM_Step, smooth, kSmooth, SurfaceMode::kFlow)->Apply(Settings);
BENCHMARK_CAPTURE(BM_Step, lugged_no_flow, kLugged, SurfaceMode::kCompaction)->Apply(Settings);
BENCHMARK_CAPTURE(BM_Step, lugged, kLugged, SurfaceMode::kFlow)->Apply(Settings);
BENCHMARK_CAPTURE(BM_Step, mesh, MeshWheel(false), SurfaceMode::kFlow)->Apply(Settings);
BENCHMARK_CAPTURE(BM_Step, mesh_12_grousers, MeshWheel(true), SurfaceMode::kFlow)->Apply(Settings);

}  // namespace
}  // namespace softsoil
