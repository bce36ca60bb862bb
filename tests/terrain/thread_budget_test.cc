#include "terrain/thread_budget.h"

#include <gtest/gtest.h>

#include <thread>
#include <vector>

namespace softsoil {
namespace {

TEST(ThreadBudget, GivesWhatIsFree) {
  ThreadBudget budget(3);
  const ThreadBudget::Share two = budget.Take(2), one = budget.Take(2), none = budget.Take(2);
  EXPECT_EQ(two.threads(), 2);
  EXPECT_EQ(one.threads(), 1);
  EXPECT_EQ(none.threads(), 0);
}

TEST(ThreadBudget, GetsItsThreadsBackAtTheEndOfTheScope) {
  ThreadBudget budget(3);
  for (int i = 0; i < 5; ++i) EXPECT_EQ(budget.Take(9).threads(), 3) << i;
}

TEST(ThreadBudget, GivesNoneToALoopThatWantsNone) {
  ThreadBudget budget(3);
  for (int wanted : {0, -1}) EXPECT_EQ(budget.Take(wanted).threads(), 0);
  EXPECT_EQ(budget.Take(3).threads(), 3);
}

TEST(ThreadBudget, IsNeverExceededByManyThreadsAtOnce) {
  constexpr int kThreads = 3;
  ThreadBudget budget(kThreads);
  std::atomic<int> taken{0}, most{0}, given{0};
  const auto take_often = [&] {
    for (int i = 0; i < 2000; ++i) {
      const ThreadBudget::Share share = budget.Take(1 + i % 3);
      const int now = taken += share.threads();
      for (int seen = most; seen < now && !most.compare_exchange_weak(seen, now);) {
      }
      given += share.threads();
      taken -= share.threads();
    }
  };
  std::vector<std::thread> threads;
  for (int t = 0; t < 6; ++t) threads.emplace_back(take_often);
  for (std::thread& thread : threads) thread.join();
  EXPECT_GT(given, 0);
  EXPECT_LE(most, kThreads);
  EXPECT_EQ(budget.Take(9).threads(), kThreads) << "all came back";
}

}  // namespace
}  // namespace softsoil
