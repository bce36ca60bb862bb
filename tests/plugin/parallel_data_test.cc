// Several mjData of one model, each stepped by a thread of its own: independent soils, the same
// bits as one after the other, and a bounded number of threads.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <future>
#include <string>
#include <thread>
#include <vector>

#include "terrain/processors.h"
#include "terrain/worker_pool.h"
#include "tests/plugin/simulation.h"

namespace softsoil {
namespace {

constexpr int kHosts = 8, kSoilThreads = 4;

Model OneWheelModel() {
  OneWheel narrow;
  narrow.wheel_geom = R"(type="cylinder" zaxis="0 1 0" size=".4 .02")";
  return Load(narrow.Mjcf());
}

std::string Settings(bool sync) {
  return "threads=" + std::to_string(kSoilThreads) + " sync=" + std::to_string(sync);
}

// A mjData of the model on soil, rolling at a speed of its own.
Data Rolling(const Model& m, bool sync, int which) {
  Data d = MakeData(m);
  EXPECT_EQ(softsoil_attach(m.get(), d.get(), Settings(sync).c_str()), 0) << softsoil_error();
  d->qvel[0] = 0.2 * which;
  return d;
}

void Step(const Model& m, const Data& d, int steps) {
  for (int i = 0; i < steps; ++i) mj_step(m.get(), d.get());
}

// All that is known of a mjData and its soil.
std::vector<double> Results(const Model& m, const Data& d) {
  std::vector<double> results(d->qpos, d->qpos + m->nq);
  results.insert(results.end(), d->qvel, d->qvel + m->nv);
  results.insert(results.end(), d->xfrc_applied, d->xfrc_applied + 6 * m->nbody);
  softsoilWheel wheel = {};
  EXPECT_EQ(softsoil_wheel(d.get(), 0, &wheel), 0) << softsoil_error();
  EXPECT_GT(wheel.compaction_energy, 0);
  results.push_back(wheel.compaction_energy);
  const auto add = [](void* user, double x, double y, double height, double sinkage) {
    auto* heights = static_cast<std::vector<double>*>(user);
    for (double value : {x, y, height, sinkage}) heights->push_back(value);
  };
  EXPECT_EQ(softsoil_visit_surface(d.get(), add, &results), 0) << softsoil_error();
  return results;
}

std::vector<double> Drive(const Model& m, bool sync, int which) {
  const Data d = Rolling(m, sync, which);
  Step(m, d, 200);
  ExpectNoWarnings(d);
  return Results(m, d);
}

struct ThreadCount {
  int soil = 0, others = 0;  // threads of this process
};

// The threads of the soil have its name.
ThreadCount CountThreads() {
  ThreadCount count;
  for (const auto& task : std::filesystem::directory_iterator("/proc/self/task")) {
    std::string name;
    std::ifstream(task.path() / "comm") >> name;
    ++(name == "softsoil" ? count.soil : count.others);
  }
  return count;
}

class ParallelData : public testing::TestWithParam<bool> {};
INSTANTIATE_TEST_SUITE_P(, ParallelData, testing::Bool(),
                         [](const auto& sync) { return sync.param ? "Sync" : "Background"; });

TEST_P(ParallelData, HaveTheBitsOfOneAfterTheOther) {
  const Model m = OneWheelModel();
  std::vector<std::future<std::vector<double>>> all;
  for (int i = 0; i < kHosts; ++i) {
    all.push_back(std::async(std::launch::async, [&m, i] { return Drive(m, GetParam(), i); }));
  }
  std::vector<std::vector<double>> together;
  for (auto& one : all) together.push_back(one.get());
  for (int i = 0; i < kHosts; ++i) EXPECT_EQ(together[i], Drive(m, GetParam(), i)) << i;
  EXPECT_NE(together[0], together[1]);
}

TEST_P(ParallelData, ShareABoundedNumberOfThreads) {
  const Model m = OneWheelModel();
  WorkerPool::Shared();
  const ThreadCount before = CountThreads();
  std::atomic<int> driving{kHosts};
  std::vector<std::future<void>> hosts;
  for (int i = 0; i < kHosts; ++i) {
    hosts.push_back(std::async(std::launch::async, [&, i] {
      Drive(m, GetParam(), i);
      --driving;
    }));
  }
  ThreadCount most;
  while (driving > 0) {
    const ThreadCount now = CountThreads();
    most = {std::max(most.soil, now.soil), std::max(most.others, now.others)};
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  for (auto& host : hosts) host.get();
  EXPECT_EQ(most.soil, Processors());
  EXPECT_GT(most.others, before.others);
  EXPECT_LE(most.others, before.others + kHosts);
}

// All workers wait at a gate until it is opened.
class BusyWorkers {
 public:
  BusyWorkers() {
    const auto wait = [opened = gate_.get_future().share()] { opened.wait(); };
    for (int i = 0; i < WorkerPool::Shared().workers(); ++i) {
      jobs_.push_back(WorkerPool::Shared().Run(wait));
    }
  }
  void Open() {
    gate_.set_value();
    for (auto& job : jobs_) job.get();
  }

 private:
  std::promise<void> gate_;
  std::vector<std::future<void>> jobs_;
};

TEST(MjDataThatIsDeleted, MayHaveAJobThatHasNotBegun) {
  const Model m = OneWheelModel();
  Data d = Rolling(m, false, 1);
  BusyWorkers workers;
  Step(m, d, 15);  // one tick
  auto deleting = std::async(std::launch::async, [&] { d.reset(); });
  deleting.wait_for(std::chrono::milliseconds(50));  // whether or not it awaits its job
  workers.Open();
  deleting.get();
}

TEST(MjDataThatIsDeleted, LeavesTheOthersAsTheyAre) {
  const Model m = OneWheelModel();
  const std::vector<double> alone = Drive(m, false, 3);
  std::atomic<bool> done{false};
  std::vector<std::future<void>> others;
  for (int i = 0; i < kHosts; ++i) {
    others.push_back(std::async(std::launch::async, [&, i] {
      while (!done) Step(m, Rolling(m, false, i), 11 + i);
    }));
  }
  EXPECT_EQ(Drive(m, false, 3), alone);
  done = true;
  for (auto& other : others) other.get();
}

}  // namespace
}  // namespace softsoil
