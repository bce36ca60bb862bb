// Past states of the soil: held as long as there is room, and never a wrong one.
#include "plugin/soil_history.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "tests/plugin/compacting_wheel.h"

namespace softsoil {
namespace {

using testing::HasSubstr;

// A wheel with a history of so many MB.
OneWheel WithHistory(const std::string& megabytes) {
  return CompactingWheel(2, "<numeric name=\"softsoil_history\" data=\"" + megabytes + "\"/>");
}

std::string WhyStepLosesSoil(const mjModel* m, mjData* d) {
  mj_step(m, d);
  EXPECT_EQ(softsoil_wheel_count(d), -1);
  return softsoil_error();
}

TEST(SmallHistory, GivesTheRightSoilOrNone) {
  constexpr int kSteps = 120, kEvery = 10;
  const OneWheel model = WithHistory("0.5");
  Simulation a(model);
  std::vector<Data> saved;
  for (int i = 0; i < kSteps / kEvery; ++i) {
    Step(a, kEvery);
    saved.push_back(CopyOf(a));
  }
  int held = 0, lost = 0;
  for (const Data& d : saved) {
    const int steps = static_cast<int>(std::lround(d->time / a.m->opt.timestep));
    mj_step(a.m.get(), d.get());
    if (softsoil_wheel_count(d.get()) == -1) {
      ++lost;
      EXPECT_THAT(softsoil_error(), HasSubstr("no longer held"));
      EXPECT_EQ(held, 0) << "the oldest go first";
      continue;
    }
    ++held;
    EXPECT_TRUE(After(0, a.m.get(), d.get()) == PlainRun(model, steps + 1)) << steps;
  }
  EXPECT_GT(held, 0);
  EXPECT_GT(lost, 0);
}

// Each time the count of copied bytes begins anew.
TEST(SmallHistory, HoldsTheLastStatesAfterAReset) {
  Simulation a(WithHistory("0.5"));
  for (int i = 0; i < 3; ++i) {
    mj_resetData(a.m.get(), a.d.get());
    Step(a, 60);
    mj_resetData(a.m.get(), a.d.get());
    Step(a, 1);
    const Data saved = CopyOf(a);
    Step(a, 1);
    mj_forward(a.m.get(), saved.get());
    EXPECT_EQ(softsoil_wheel_count(saved.get()), 1) << softsoil_error();
  }
}

TEST(SmallHistory, HoldsTheLastStatesAfterARestoration) {
  Simulation a(WithHistory("0.5"));
  Step(a, 5);
  const Data early = CopyOf(a);
  mj_forward(a.m.get(), early.get());  // now held there
  for (int i = 0; i < 3; ++i) {
    Step(a, 60);
    mj_copyData(a.d.get(), a.m.get(), early.get());
    Step(a, 1);
    const Data saved = CopyOf(a);
    Step(a, 1);
    mj_forward(a.m.get(), saved.get());
    EXPECT_EQ(softsoil_wheel_count(saved.get()), 1) << softsoil_error();
  }
}

TEST(LostState, IsToldByQuestionsAndMendedByRestoring) {
  Simulation a(WithHistory("0.1")), plain(WithHistory("0.1"));
  Step(a, 20);
  const Data saved = CopyOf(a);
  softsoilSnapshot* snapshot = softsoil_snapshot(a.d.get());
  Step(a, 100);
  mj_copyData(a.d.get(), a.m.get(), saved.get());
  double height = 1;
  EXPECT_EQ(softsoil_height(a.d.get(), 0, 0, &height), -1);
  EXPECT_THAT(softsoil_error(), HasSubstr("no longer held"));
  EXPECT_THAT(WhyStepLosesSoil(a.m.get(), a.d.get()), HasSubstr("softsoil_history is too small"));
  mj_copyData(a.d.get(), a.m.get(), saved.get());
  ASSERT_EQ(softsoil_restore(a.d.get(), snapshot), 0) << softsoil_error();
  softsoil_free_snapshot(snapshot);
  EXPECT_TRUE(After(30, a) == After(50, plain));
}

TEST(LostState, IsThatOfADeletedMjDataInACopyThatHasNotStepped) {
  Simulation a(CompactingWheel(2));
  Step(a, 20);
  const Data copy = CopyOf(a);
  a.d = MakeData(a.m);
  EXPECT_THAT(WhyStepLosesSoil(a.m.get(), copy.get()), HasSubstr("that mjData is gone"));
}

TEST(LostState, IsThatOfAnotherProcess) {
  Simulation a(CompactingWheel(2));
  Step(a, 20);
  a.d->userdata[0] = kLeastHistory + 12345;
  a.d->userdata[1] = 20;
  EXPECT_THAT(WhyStepLosesSoil(a.m.get(), a.d.get()), HasSubstr("soil state 20 of a mjData"));
}

TEST(Userdata, MustNotBeTheHostsWhereTheMarkIs) {
  for (const double value : {1.0, -3.5, std::nan("")}) {
    Simulation a(CompactingWheel(2));
    Step(a, 20);
    a.d->userdata[0] = a.d->userdata[1] = value;
    EXPECT_THAT(WhyStepLosesSoil(a.m.get(), a.d.get()),
                HasSubstr("they belong to softsoil; make <size nuserdata> larger"));
  }
}

TEST(Userdata, IsTheHostsInFrontOfTheMark) {
  Simulation a(CompactingWheel(5)), b(CompactingWheel(5));
  for (int i = 0; i < 60; ++i) {
    for (int k = 0; k < 3; ++k) a.d->userdata[k] = i + k;
    Step(a, 1);
  }
  mj_copyData(b.d.get(), b.m.get(), a.d.get());
  EXPECT_TRUE(After(20, b) == After(20, a));
  for (int k = 0; k < 3; ++k) EXPECT_EQ(b.d->userdata[k], 59 + k);
}

TEST(Userdata, IsTheHostsWithoutAHistory) {
  Simulation a(WithHistory("0")), plain(CompactingWheel());
  for (double* number : {&a.d->userdata[0], &a.d->userdata[1]}) *number = 7;
  EXPECT_TRUE(After(60, a) == After(60, plain));
  EXPECT_EQ(a.d->userdata[0], 7);
  EXPECT_EQ(a.d->userdata[1], 7);
}

}  // namespace
}  // namespace softsoil
