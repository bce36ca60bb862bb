// When memory runs out, wherever that is: the soil stays as it was before or after the step, says
// why it rests, and goes on from a snapshot as if nothing had been.
#include <gmock/gmock.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <functional>
#include <new>
#include <string>
#include <vector>

#include "terrain/worker_pool.h"
#include "tests/faults/driven_wheel.h"
#include "tests/faults/failing_memory.h"

namespace softsoil {
namespace {

using testing::EndsWith;
using testing::HasSubstr;

constexpr int kSteps = 25;  // more than two periods of the soil clock
constexpr double kFuture = kSteps * 0.001;
constexpr long kLeak = 4096;            // [bytes]
constexpr long kHistory = 3 * 1000000;  // [bytes]  one of 1 MB, in which sizes are estimates

double At(const Heights& heights, const std::pair<double, double>& node) {
  const auto it = heights.find(node);
  return it != heights.end() ? it->second : 0;  // the undisturbed ground is level
}

void ExpectBetween(const Heights& before, const Heights& after, const Heights& heights) {
  for (const Heights* all : {&before, &after, &heights}) {
    for (const auto& [node, height] : *all) {
      const auto [low, high] = std::minmax({At(before, node), At(after, node)});
      EXPECT_LE(low, At(heights, node)) << node.first << ", " << node.second;
      EXPECT_GE(high, At(heights, node)) << node.first << ", " << node.second;
    }
  }
}

class OutOfMemoryInAStep : public testing::TestWithParam<std::tuple<int, const char*>> {
 protected:
  OutOfMemoryInAStep()
      : wheel_(WheelOnLooseSoil(std::get<0>(GetParam())), std::get<1>(GetParam())) {
    for (int i = 0; i < kSteps; ++i) {
      heights_.push_back(HeightsOf(wheel_.d.get()));
      wheel_.Step();
    }
    heights_.push_back(HeightsOf(wheel_.d.get()));
    plain_ = HashOf(wheel_.d.get());
  }

  // Drives until the soil rests, at most kSteps. Whether an allocation failed meanwhile.
  bool Drive(Whose whose, long first, long count) {
    wheel_.PutBack();
    testing::internal::CaptureStderr();
    step_ = 0;
    bool has_failed = false;
    {
      const FailingMemory memory(whose, first, count);
      while (step_ < kSteps && softsoil_wheel_count(wheel_.d.get()) == 1) {
        wheel_.Step();
        ++step_;
      }
      has_failed = memory.HasFailed();
    }
    testing::internal::GetCapturedStderr();
    return has_failed;
  }

  void ExpectRestingSoil() {
    const mjData* d = wheel_.d.get();
    EXPECT_EQ(softsoil_wheel_count(d), -1);
    EXPECT_STREQ(softsoil_error(), "this mjData has lost its soil: out of memory");
    ExpectBetween(heights_[step_ - 1], heights_[step_], HeightsOf(d));
    for (int k = 0; k < 6; ++k) EXPECT_EQ(wheel_.Row()[k], 0) << k;
    const std::uint64_t hash = HashOf(d);
    softsoilSnapshot* resting = softsoil_snapshot(d);
    ASSERT_NE(resting, nullptr) << softsoil_error();
    EXPECT_EQ(softsoil_restore(wheel_.d.get(), resting), 0) << softsoil_error();
    softsoil_free_snapshot(resting);
    EXPECT_EQ(HashOf(d), hash);
    EXPECT_EQ(softsoil_wheel_count(d), 1);
  }

  // All allocations of the drive, one after the other; later ones in longer strides.
  void FailEverywhere(Whose whose, long count) {
    int rested = 0, went_on = 0;
    wheel_.Future(kFuture);
    const long allocated = AllocatedBytes();
    for (long n = 1; Drive(whose, n, count); n += 1 + n / 40) {
      SCOPED_TRACE("allocation " + std::to_string(n) + ", step " + std::to_string(step_));
      if (softsoil_wheel_count(wheel_.d.get()) == 1) {
        ++went_on;
        EXPECT_EQ(step_, kSteps);
        EXPECT_EQ(HashOf(wheel_.d.get()), plain_);
      } else {
        ++rested;
        ExpectRestingSoil();
      }
      ASSERT_EQ(wheel_.Future(kFuture), plain_);
      if (HasFailure()) return;
    }
    wheel_.Future(kFuture);
    EXPECT_LT(AllocatedBytes() - allocated, std::get<0>(GetParam()) > 0 ? kHistory : kLeak);
    RecordProperty("grown", static_cast<int>(AllocatedBytes() - allocated));
    RecordProperty("rested", rested);
    RecordProperty("went_on", went_on);
    EXPECT_GT(rested + went_on, 20);
  }

  DrivenWheel wheel_;
  std::vector<Heights> heights_;  // before the first step, and after each
  std::uint64_t plain_ = 0;
  int step_ = 0;
};

TEST_P(OutOfMemoryInAStep, OnceInTheThreadThatSteps) { FailEverywhere(Whose::kThisThread, 1); }

TEST_P(OutOfMemoryInAStep, ForGoodInTheThreadThatSteps) {
  FailEverywhere(Whose::kThisThread, kAllFurther);
}

TEST_P(OutOfMemoryInAStep, OnceInAWorker) { FailEverywhere(Whose::kOtherThreads, 1); }

TEST_P(OutOfMemoryInAStep, ForGoodInAllThreads) { FailEverywhere(Whose::kAnyThread, kAllFurther); }

INSTANTIATE_TEST_SUITE_P(OfEveryKind, OutOfMemoryInAStep,
                         testing::Values(std::make_tuple(0, "threads=2"),
                                         std::make_tuple(0, "sync=1 threads=1"),
                                         std::make_tuple(2, "threads=1 history=1")));

// A call of the C interface, failing at every allocation in turn. What is asked does not change.
void FailEverywhere(const std::function<int()>& call, const mjData* d) {
  const std::uint64_t hash = HashOf(d);
  for (long n = 1;; n += 1 + n / 20) {
    SCOPED_TRACE("allocation " + std::to_string(n));
    int result = 0;
    bool has_failed = false;
    {
      const FailingMemory memory(Whose::kThisThread, n);
      result = call();
      has_failed = memory.HasFailed();
    }
    if (result != 0) {
      EXPECT_THAT(softsoil_error(), EndsWith("out of memory"));
      EXPECT_EQ(HashOf(d), hash);
    }
    ASSERT_TRUE(result == 0 || has_failed);
    if (!has_failed) return;
  }
}

TEST(OutOfMemoryInACall, SaysSoAndChangesNothing) {
  DrivenWheel wheel;
  mjModel* m = wheel.m.get();
  mjData* d = wheel.d.get();
  const std::string path = testing::TempDir() + "out_of_memory_" + std::to_string(getpid());
  ASSERT_EQ(softsoil_save_simulation(m, d, path.c_str()), 0) << softsoil_error();
  const auto snapshot = [&] {
    softsoilSnapshot* made = softsoil_snapshot(d);
    softsoil_free_snapshot(made);
    return made != nullptr ? 0 : -1;
  };
  std::uint64_t hash = 0;
  softsoilGround ground;
  double height = 0;
  const std::vector<std::function<int()>> calls = {
      snapshot,
      [&] { return softsoil_restore(d, wheel.snapshot); },
      [&] { return softsoil_save(d, path.c_str()); },
      [&] { return softsoil_save_simulation(m, d, path.c_str()); },
      [&] { return softsoil_load(d, path.c_str()); },
      [&] { return softsoil_load_simulation(m, d, path.c_str()); },
      [&] { return softsoil_hash(d, &hash); },
      [&] { return softsoil_ground(d, &ground); },
      [&] { return softsoil_height(d, 0.1, 0.1, &height); },
  };
  for (std::size_t i = 0; i < calls.size(); ++i) {
    SCOPED_TRACE("call " + std::to_string(i));
    FailEverywhere(calls[i], d);
  }
  const Data other = MakeData(wheel.m);
  FailEverywhere([&] { return softsoil_copy(other.get(), d); }, d);
  EXPECT_EQ(HashOf(other.get()), HashOf(d));
  FailEverywhere([&] { return softsoil_copy(d, d); }, d);
  std::remove(path.c_str());
}

TEST(OutOfMemoryInACall, RestoresAllOrNothing) {
  for (const int nuserdata : {0, 2}) {
    DrivenWheel wheel(WheelOnLooseSoil(nuserdata));
    mjData* d = wheel.d.get();
    const std::uint64_t driven = HashOf(d);
    ASSERT_EQ(softsoil_reset(wheel.m.get(), d), 0) << softsoil_error();
    EXPECT_NE(HashOf(d), driven);
    FailEverywhere([&] { return softsoil_restore(d, wheel.snapshot); }, d);
    EXPECT_EQ(HashOf(d), driven);
  }
}

TEST(OutOfMemoryInACall, LeavesAMjDataWithoutSoilOrWithAllOfIt) {
  const Model m = Load(WheelOnLooseSoil().Mjcf());
  const Data d = MakeData(m);
  testing::internal::CaptureStderr();
  for (long n = 1;; n += 1 + n / 20) {
    const int result = [&] {
      const FailingMemory memory(Whose::kThisThread, n);
      return softsoil_attach(m.get(), d.get(), nullptr);
    }();
    if (result == 0) break;
    ASSERT_THAT(softsoil_error(), HasSubstr("out of memory")) << n;
    EXPECT_EQ(softsoil_wheel_count(d.get()), -1);
    EXPECT_STREQ(softsoil_error(), "this mjData has no soil: call softsoil_attach() first");
  }
  testing::internal::GetCapturedStderr();
  mj_step(m.get(), d.get());
  EXPECT_EQ(softsoil_wheel_count(d.get()), 1);
}

// More helpers than processors; those that came before memory ran out need what they work on.
TEST(OutOfMemoryInALoop, LeavesItToTheHelpersThatAreThere) {
  WorkerPool pool(4);
  std::vector<std::atomic<int>> calls(100);
  const std::function<void(int)> body = [&](int i) { ++calls[i]; };
  for (long n = 1;; ++n) {
    for (auto& of_one : calls) of_one = 0;
    const FailingMemory memory(Whose::kThisThread, n);
    try {
      pool.ForEach(100, 4, body);
    } catch (const std::bad_alloc&) {
      ASSERT_EQ(n, 1) << "but for the loop itself";
      continue;
    }
    for (const auto& of_one : calls) ASSERT_EQ(of_one, 1) << n;
    if (!memory.HasFailed()) return;
  }
}

}  // namespace
}  // namespace softsoil
