// Soil as state: what copies, snapshots, files, hashes and marks cost on a 2.5 cm grid with 30
// volumes. Memory is what the allocator has handed out, not what softsoil says.
#include <benchmark/benchmark.h>

#include <cstdio>
#include <cstring>
#include <ctime>
#include <string>
#include <vector>

#include "tests/plugin/heap.h"
#include "tests/plugin/hmmwv.h"

namespace softsoil {
namespace {

// Of all threads together.
double CpuSeconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

std::string SoilSetting(const benchmark::State& state) {
  return "threads=1 " + std::string(kSoils[state.range(0)]);
}

// An HMMWV on an area that is deformed. The last one is kept for the next benchmark.
const Hmmwv& OnArea(benchmark::State& state) {
  static std::unique_ptr<Hmmwv> last;
  static std::vector<int64_t> of;
  static double bytes = 0;
  const std::vector<int64_t> wanted = {state.range(0), state.range(1)};
  if (of != wanted) {
    last = nullptr;
    last = std::make_unique<Hmmwv>(SoilSetting(state));
    last->SetGoing(0);
    const double before = HeapBytes();
    DentArea(last->ground(), static_cast<double>(state.range(1)), state.range(0) != 0);
    last->WaitForSoil();
    bytes = HeapBytes() - before;
    of = wanted;
  }
  state.SetLabel(kSoils[state.range(0)]);
  state.counters["bytes_per_m2"] = bytes / static_cast<double>(state.range(1));
  return *last;
}

void CountBytes(benchmark::State& state, const Hmmwv& hmmwv) {
  double bytes = 0;
  StateWriter writer([&](const void*, std::size_t count) { bytes += static_cast<double>(count); });
  Write(SoilOf(hmmwv.d())->State(hmmwv.d()), writer);
  writer.Finish();
  state.SetBytesProcessed(static_cast<int64_t>(bytes) * state.iterations());
}

void BM_Copy(benchmark::State& state) {
  const Hmmwv& from = OnArea(state);
  const Hmmwv to(SoilSetting(state));
  for (auto _ : state) RequireSuccess(softsoil_copy(to.d(), from.d()));
}

void BM_Snapshot(benchmark::State& state) {
  const Hmmwv& hmmwv = OnArea(state);
  for (auto _ : state) softsoil_free_snapshot(softsoil_snapshot(hmmwv.d()));
}

void BM_Restore(benchmark::State& state) {
  const Hmmwv& hmmwv = OnArea(state);
  softsoilSnapshot* snapshot = softsoil_snapshot(hmmwv.d());
  for (auto _ : state) RequireSuccess(softsoil_restore(hmmwv.d(), snapshot));
  softsoil_free_snapshot(snapshot);
}

// A node sinks in ground that a copy shares.
void BM_FirstWrite(benchmark::State& state) {
  const Ground& ground = OnArea(state).ground();
  double sinkage = 0.06;
  for (auto _ : state) {
    state.PauseTiming();
    Ground copy = ground;
    state.ResumeTiming();
    copy.DeepenPlastic(0, {{{8, 8}, sinkage += 1e-6}});
    state.PauseTiming();
    copy = ground;
    state.ResumeTiming();
  }
}

constexpr const char* kFile = "/tmp/softsoil_state_benchmark";

void BM_Save(benchmark::State& state) {
  const Hmmwv& hmmwv = OnArea(state);
  for (auto _ : state) RequireSuccess(softsoil_save(hmmwv.d(), kFile));
  CountBytes(state, hmmwv);
}

void BM_Load(benchmark::State& state) {
  const Hmmwv& hmmwv = OnArea(state);
  const Hmmwv to(SoilSetting(state));
  RequireSuccess(softsoil_save(hmmwv.d(), kFile));
  for (auto _ : state) RequireSuccess(softsoil_load(to.d(), kFile));
  CountBytes(state, hmmwv);
  std::remove(kFile);
}

void BM_Hash(benchmark::State& state) {
  const Hmmwv& hmmwv = OnArea(state);
  uint64_t hash = 0;
  for (auto _ : state) RequireSuccess(softsoil_hash(hmmwv.d(), &hash));
  CountBytes(state, hmmwv);
}

// What hashing and saving compare with.
void BM_Memcpy(benchmark::State& state) {
  const std::vector<char> from(std::size_t{1} << 26, 'x');
  std::vector<char> to(from.size());
  for (auto _ : state) {
    std::memcpy(to.data(), from.data(), from.size());
    benchmark::ClobberMemory();
  }
  state.SetBytesProcessed(static_cast<int64_t>(from.size()) * state.iterations());
}
BENCHMARK(BM_Memcpy)->Unit(benchmark::kMillisecond);

void Areas(benchmark::internal::Benchmark* family) {
  family->ArgNames({"compacts", "m2"})->Unit(benchmark::kMillisecond)->UseRealTime();
  for (const int compacts : {0, 1}) {
    for (const int area : {1, 10, 100, 1000}) family->Args({compacts, area});
  }
}
BENCHMARK(BM_Copy)->Apply(Areas);
BENCHMARK(BM_Snapshot)->Apply(Areas);
BENCHMARK(BM_Restore)->Apply(Areas);
BENCHMARK(BM_FirstWrite)->Apply(Areas);
BENCHMARK(BM_Save)->Apply(Areas);
BENCHMARK(BM_Load)->Apply(Areas);
BENCHMARK(BM_Hash)->Apply(Areas);

// The copy of a HMMWV behind which lie 100 m of tracks: the last steps driven, the rest pressed.
void BM_CopyAfter100m(benchmark::State& state) {
  Hmmwv from(SoilSetting(state)), to(SoilSetting(state));
  from.SetGoing(5);
  const double empty = HeapBytes();
  DentTracks(from.ground(), 100, state.range(0) != 0);
  from.Step(50);
  from.WaitForSoil();
  const double before = HeapBytes();
  RequireSuccess(softsoil_copy(to.d(), from.d()));
  const double after = HeapBytes();
  for (auto _ : state) RequireSuccess(softsoil_copy(to.d(), from.d()));
  state.SetLabel(kSoils[state.range(0)]);
  state.counters["soil_MB"] = (before - empty) / 1e6;
  state.counters["more_%"] = 100 * (after - before) / (before - empty);
}
BENCHMARK(BM_CopyAfter100m)
    ->ArgName("compacts")
    ->Arg(0)
    ->Arg(1)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

// Steps of a driving HMMWV with marks in userdata, and their processor time over that of the same
// steps without, in turns.
void BM_StepWithMarks(benchmark::State& state) {
  constexpr int kSteps = 10;
  const std::string settings = SoilSetting(state) + " sync=1";  // a soil job counts where it began
  Hmmwv plain(settings), marked(settings, kMarkSize);
  for (Hmmwv* hmmwv : {&plain, &marked}) hmmwv->SetGoing(5);
  double plain_time = 0, marked_time = 0;
  for (auto _ : state) {
    const double start = CpuSeconds();
    plain.Step(kSteps);
    const double middle = CpuSeconds();
    marked.Step(kSteps);
    marked_time += CpuSeconds() - middle;
    plain_time += middle - start;
    state.SetIterationTime(CpuSeconds() - middle);
  }
  state.SetLabel(kSoils[state.range(0)]);
  state.counters["ratio"] = marked_time / plain_time;
  state.counters["plain_step_ms"] =
      1e3 * plain_time / kSteps / static_cast<double>(state.iterations());
}
BENCHMARK(BM_StepWithMarks)
    ->ArgName("compacts")
    ->Arg(0)
    ->Arg(1)
    ->Unit(benchmark::kMillisecond)
    ->UseManualTime()
    ->Iterations(100);

// Memory [bytes] that a HMMWV has taken at the end of half a second at rest and at the end of 0.3 s
// of driving.
struct Taken {
  double at_rest, driven;
};
Taken MemoryTaken(const std::string& settings, int nuserdata) {
  const double before = HeapBytes();
  Hmmwv hmmwv(settings, nuserdata);
  hmmwv.SetGoing(5);
  const double at_rest = HeapBytes();
  hmmwv.Step(300);
  hmmwv.WaitForSoil();
  return {at_rest - before, HeapBytes() - before};
}

// What a history takes that may take as much as `allowed_MB`, and how fast while driving.
void BM_History(benchmark::State& state) {
  const std::string allowed = " history=" + std::to_string(state.range(1));
  Taken plain = {}, marked = {};
  for (auto _ : state) {
    plain = MemoryTaken(SoilSetting(state), 0);
    marked = MemoryTaken(SoilSetting(state) + allowed, kMarkSize);
  }
  state.SetLabel(kSoils[state.range(0)]);
  state.counters["history_MB"] = (marked.driven - plain.driven) / 1e6;
  state.counters["MB_per_s"] =
      ((marked.driven - marked.at_rest) - (plain.driven - plain.at_rest)) / 1e6 / 0.3;
}
BENCHMARK(BM_History)
    ->ArgNames({"compacts", "allowed_MB"})
    ->ArgsProduct({{0, 1}, {10, 10000}})
    ->Iterations(1)
    ->Unit(benchmark::kSecond);

}  // namespace
}  // namespace softsoil
