// HMMWVs on soft soil, every mjData stepped by a thread of its own, all at once: time steps per
// second of all together. parallel_data.py makes a ratio of it.
#include <benchmark/benchmark.h>
#include <mujoco/mujoco.h>

#include <cstdio>
#include <cstdlib>
#include <memory>
#include <thread>
#include <vector>

#include "plugin/softsoil.h"

namespace {

constexpr int kSettling = 500, kSteps = 1000;  // [-]  of 1 ms
constexpr int kDrive = 1;                      // actuator
constexpr double kTorque = 3000;               // [N m]

struct Delete {
  void operator()(mjModel* m) const { mj_deleteModel(m); }
  void operator()(mjData* d) const { mj_deleteData(d); }
};
using Model = std::unique_ptr<mjModel, Delete>;
using Data = std::unique_ptr<mjData, Delete>;

void Require(bool succeeded, const char* error) {
  if (succeeded) return;
  std::fprintf(stderr, "%s\n", error);
  std::exit(EXIT_FAILURE);
}

Model Hmmwv() {
  char error[500] = "";
  Model m(mj_loadXML(SOFTSOIL_SOURCE_DIR "/models/scenes/hmmwv_flat.xml", nullptr, error,
                     sizeof error));
  Require(m != nullptr, error);
  return m;
}

void Step(const Model& m, const Data& d, int steps) {
  for (int i = 0; i < steps; ++i) mj_step(m.get(), d.get());
}

// A vehicle that has settled and is about to drive off.
Data Vehicle(const Model& m) {
  Data d(mj_makeData(m.get()));
  Require(softsoil_attach(m.get(), d.get(), "sync=1 threads=1") == 0, softsoil_error());
  Step(m, d, kSettling);
  d->ctrl[kDrive] = kTorque;
  return d;
}

void BM_Steps(benchmark::State& state) {
  const Model m = Hmmwv();
  std::vector<Data> vehicles(state.range(0));
  for (Data& d : vehicles) d = Vehicle(m);
  for (auto _ : state) {
    std::vector<std::thread> threads;
    for (const Data& d : vehicles) threads.emplace_back([&] { Step(m, d, kSteps); });
    for (std::thread& thread : threads) thread.join();
  }
  state.SetItemsProcessed(state.iterations() * state.range(0) * kSteps);
}
BENCHMARK(BM_Steps)
    ->ArgName("data")
    ->Arg(1)
    ->Arg(2)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond)
    ->Iterations(2);

}  // namespace
