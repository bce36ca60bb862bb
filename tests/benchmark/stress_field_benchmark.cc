// The stress in many volumes under many forces, by the direct sum and by sums of Gaussians, on flat
// ground and in a rut 20 cm deep. `ratio`, of times in the same run, is the direct sum's to the
// Gaussians', or what more volumes and forces take to what fewer take.
#include <benchmark/benchmark.h>

#include <cmath>
#include <ctime>

#include "terrain/stress_field.h"
#include "tests/benchmark/threads.h"

namespace softsoil {
namespace {

constexpr double kSpacing = 0.025;  // [m]
constexpr int kVolumes = 30;        // per column

struct StressCase {
  ColumnBatch batch;
  SurfaceLoad load;
  std::vector<float> stress;
};

// Of the rut's cross section, along x.
double RutHeight(double y) {
  const double d = std::abs(y);
  if (d < 0.25) return -0.2;
  return std::min(-0.2 + (d - 0.25) * 0.7, 0.0);
}

// Visits `count` nodes in rows of about the square root of them, around the origin.
template <class Visit>
void ForEachNode(int count, const Visit& visit) {
  const int side = static_cast<int>(std::sqrt(count));
  for (int k = 0; k < count; ++k) visit(GridNode{k / side - count / side / 2, k % side - side / 2});
}

StressCase MakeCase(int volumes, int forces, bool is_rut) {
  const auto height = [&](GridNode node) { return is_rut ? RutHeight(node.j * kSpacing) : 0.0; };
  StressCase c;
  c.batch.volumes = kVolumes;
  ForEachNode(volumes / kVolumes, [&](GridNode node) {
    c.batch.x.push_back(node.i * kSpacing);
    c.batch.y.push_back(node.j * kSpacing);
    c.batch.surface_pressure.push_back(0);
    c.batch.soil.push_back(0);
    for (int k = 0; k < kVolumes; ++k) {
      c.batch.z.push_back(height(node) - (k + 0.5) * kSpacing);
    }
  });
  ForEachNode(forces, [&](GridNode node) {
    c.load.push_back({node, node.i * kSpacing, node.j * kSpacing, height(node), {10, 5, -50}, 0});
  });
  return c;
}

StressSettings SettingsFor(int threads) { return {{5}, 1.25 * kSpacing, threads}; }

// [s]  of this thread, so that what else runs counts little.
double ThreadTime() {
  timespec time;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

double Seconds(const StressField& field, StressCase* c) {
  const double start = ThreadTime();
  field.VerticalStress(c->batch, c->load, &c->stress);
  benchmark::DoNotOptimize(c->stress.data());
  return ThreadTime() - start;
}

void BM_DirectStress(benchmark::State& state) {
  StressCase c = MakeCase(61440, 360, false);
  const auto field = MakeDirectStress(SettingsFor(static_cast<int>(state.range(0))));
  for (auto _ : state) Seconds(*field, &c);
  state.counters["pairs/s"] =
      benchmark::Counter(static_cast<double>(c.batch.z.size() * c.load.size()),
                         benchmark::Counter::kIsIterationInvariantRate);
}
BENCHMARK(BM_DirectStress)->Apply(OnOneAndTwoThreads);

void BM_GaussianStress(benchmark::State& state) {
  StressCase c = MakeCase(61440, 360, false);
  const auto field = MakeGaussianStress(SettingsFor(static_cast<int>(state.range(0))), kSpacing);
  for (auto _ : state) Seconds(*field, &c);
}
BENCHMARK(BM_GaussianStress)->Apply(OnOneAndTwoThreads);

// One turn of each after the other, on one thread; the time is the Gaussians'.
void BM_AgainstDirect(benchmark::State& state) {
  StressCase c = MakeCase(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)),
                          state.range(2) != 0);
  const auto direct = MakeDirectStress(SettingsFor(1));
  const auto gaussian = MakeGaussianStress(SettingsFor(1), kSpacing);
  double direct_time = 0, gaussian_time = 0;
  for (auto _ : state) {
    direct_time += Seconds(*direct, &c);
    const double time = Seconds(*gaussian, &c);
    gaussian_time += time;
    state.SetIterationTime(time);
  }
  state.counters["ratio"] = direct_time / gaussian_time;
}
BENCHMARK(BM_AgainstDirect)
    ->ArgNames({"volumes", "forces", "rut"})
    ->Args({61440, 360, 0})
    ->ArgsProduct({{59010}, {100, 250, 500, 1000}, {0}})
    ->ArgsProduct({{370830}, {400, 1000, 2000, 4000}, {0}})
    ->Args({61440, 360, 1})
    ->Args({370830, 4000, 1})
    ->UseManualTime()
    ->MinTime(0.1)
    ->Unit(benchmark::kMillisecond);

// 370,830 volumes with 4,000 forces against 59,010 with 1,000.
void BM_Growth(benchmark::State& state) {
  StressCase few = MakeCase(59010, 1000, false), many = MakeCase(370830, 4000, false);
  const auto field = MakeGaussianStress(SettingsFor(1), kSpacing);
  double few_time = 0, many_time = 0;
  for (auto _ : state) {
    few_time += Seconds(*field, &few);
    const double time = Seconds(*field, &many);
    many_time += time;
    state.SetIterationTime(time);
  }
  state.counters["ratio"] = many_time / few_time;
}
BENCHMARK(BM_Growth)->UseManualTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace softsoil
