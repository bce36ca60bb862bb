// Threads that each copy one mjData at rest and go on with controls of their own.
#include <gtest/gtest.h>

#include <thread>
#include <vector>

#include "tests/plugin/compacting_wheel.h"

namespace softsoil {
namespace {

constexpr int kThreads = 4, kRounds = 5, kSteps = 30;

// With marks in userdata and without.
class Rollouts : public testing::TestWithParam<int> {
 protected:
  Rollouts() : main_(CompactingWheel(GetParam())) {
    main_.d->qvel[0] = 1;
    Step(main_, 61);
    for (int i = 0; i < kThreads; ++i) copies_.push_back(MakeData(main_.m));
  }

  // Into copy i, from the main mjData.
  Moment RollOut(int i, int round) {
    const mjModel* m = main_.m.get();
    mjData* d = copies_[i].get();
    mj_copyData(d, m, main_.d.get());
    if (GetParam() == 0) {
      EXPECT_EQ(softsoil_copy(d, main_.d.get()), 0) << softsoil_error();
    }
    d->qvel[0] = 0.5 * i + 0.1 * round;
    return After(kSteps, m, d);
  }

  Simulation main_;
  std::vector<Data> copies_;
};
INSTANTIATE_TEST_SUITE_P(With, Rollouts, testing::Values(0, 2),
                         [](const auto& info) { return info.param == 0 ? "NoMarks" : "Marks"; });

TEST_P(Rollouts, OfOneMjDataInThreadsAreAsOneAfterTheOther) {
  const std::uint64_t before = Hash(main_.d.get());
  for (int round = 0; round < kRounds; ++round) {
    std::vector<Moment> expected, results(kThreads);
    std::vector<std::thread> threads;
    for (int i = 0; i < kThreads; ++i) {
      threads.emplace_back([&, i] { results[i] = RollOut(i, round); });
    }
    for (std::thread& thread : threads) thread.join();
    for (int i = 0; i < kThreads; ++i) expected.push_back(RollOut(i, round));
    for (int i = 0; i < kThreads; ++i) EXPECT_TRUE(results[i] == expected[i]) << i;
    EXPECT_FALSE(results[0] == results[1]) << "they differ";
    Step(main_, 7);
  }
  EXPECT_NE(Hash(main_.d.get()), before);
}

// Its soil follows the mark at the first question, which is that of several threads.
TEST(RolloutsOfAMjDataThatWasJustCopied, AreAsOneAfterTheOther) {
  Simulation main(CompactingWheel(2)), copied(CompactingWheel(2));
  main.d->qvel[0] = 1;
  Step(main, 61);
  const mjModel* m = copied.m.get();
  mj_copyData(copied.d.get(), m, main.d.get());
  std::vector<Data> copies;
  std::vector<std::thread> threads;
  for (int i = 0; i < kThreads; ++i) copies.push_back(MakeData(copied.m));
  for (int i = 0; i < kThreads; ++i) {
    threads.emplace_back([&, i] {
      EXPECT_EQ(softsoil_copy(copies[i].get(), copied.d.get()), 0) << softsoil_error();
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (const Data& d : copies) EXPECT_EQ(Hash(d.get()), Hash(main.d.get()));
}

}  // namespace
}  // namespace softsoil
