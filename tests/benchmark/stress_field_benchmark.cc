// The stress in 61,440 volumes under 360 forces: a patch of 32 by 64 columns of 30 volumes.
#include <benchmark/benchmark.h>

#include "terrain/stress_field.h"
#include "tests/benchmark/threads.h"

namespace softsoil {
namespace {

constexpr double kSpacing = 0.025;  // [m]
constexpr int kColumnsX = 32, kColumnsY = 64, kVolumes = 30, kForcesX = 18, kForcesY = 20;

ColumnBatch Columns() {
  ColumnBatch batch;
  batch.volumes = kVolumes;
  for (int i = 0; i < kColumnsX; ++i) {
    for (int j = 0; j < kColumnsY; ++j) {
      batch.x.push_back(i * kSpacing);
      batch.y.push_back(j * kSpacing);
      batch.surface_pressure.push_back(0);
      batch.soil.push_back(0);
      for (int k = 0; k < kVolumes; ++k) batch.z.push_back(-(k + 0.5) * kSpacing);
    }
  }
  return batch;
}

SurfaceLoad Load() {
  SurfaceLoad load;
  for (int i = 0; i < kForcesX; ++i) {
    for (int j = 0; j < kForcesY; ++j) {
      const GridNode node{7 + i, 22 + j};
      load.push_back({node, node.i * kSpacing, node.j * kSpacing, 0, {10, 0, -50}, 0});
    }
  }
  return load;
}

void BM_DirectStress(benchmark::State& state) {
  const ColumnBatch columns = Columns();
  const SurfaceLoad load = Load();
  const auto field = MakeDirectStress({{5}, 1.25 * kSpacing, static_cast<int>(state.range(0))});
  std::vector<float> stress;
  for (auto _ : state) {
    field->VerticalStress(columns, load, &stress);
    benchmark::DoNotOptimize(stress.data());
  }
  state.counters["pairs/s"] = benchmark::Counter(static_cast<double>(stress.size()) * load.size(),
                                                 benchmark::Counter::kIsIterationInvariantRate);
}
BENCHMARK(BM_DirectStress)->Apply(OnOneAndTwoThreads);

}  // namespace
}  // namespace softsoil
