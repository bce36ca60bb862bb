#include "plugin/step_watch.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "tests/plugin/flyer.h"

namespace softsoil {
namespace {

using testing::Contains;
using testing::Each;
using testing::ElementsAre;
using testing::Not;

constexpr StepEvent kFirst = StepEvent::kFirst, kNextStep = StepEvent::kNextStep,
                    kSameInstant = StepEvent::kSameInstant, kTrial = StepEvent::kTrial,
                    kBack = StepEvent::kBack, kJump = StepEvent::kJump;

// A watch that is asked by hand. All joints move and all are accelerated.
struct ByHand {
  Model m = Flyer(R"(timestep="1")");
  Data d = MakeData(m);
  StepWatch watch;

  ByHand() {
    std::fill_n(d->qvel, m->nv, 0.5);
    std::fill_n(d->qacc, m->nv, 0.1);
  }
  StepEvent See(double time) {
    d->time = time;
    return watch.See(m.get(), d.get());
  }
  StepEvent SeeMoved(double time) {
    for (int i = 0; i < m->nq; ++i) d->qpos[i] = std::sin(time + i);
    return See(time);
  }
  StepEvent SeeVelocity(double time, int dof, double velocity) {
    const double before = std::exchange(d->qvel[dof], velocity);
    const StepEvent event = See(time);
    d->qvel[dof] = before;
    return event;
  }
  StepEvent SeePosition(double time, int coordinate) {
    const double before = d->qpos[coordinate];
    d->qpos[coordinate] += 1e-6;
    const StepEvent event = See(time);
    d->qpos[coordinate] = before;
    return event;
  }
};

std::vector<StepEvent> See(const std::vector<double>& times, int integrator = mjINT_EULER) {
  ByHand asked;
  asked.m->opt.integrator = integrator;
  std::vector<StepEvent> events;
  for (const double time : times) events.push_back(asked.SeeMoved(time));
  return events;
}

TEST(StepWatch, AcceptsOneStepPerTimeStep) {
  EXPECT_THAT(See({0, 1, 2}), ElementsAre(kFirst, kNextStep, kNextStep));
}

TEST(StepWatch, TakesTheStagesOfRungeKuttaForTrials) {
  EXPECT_THAT(
      See({0, 0.5, 0.5, 1, 1, 1.5, 1.5, 2, 2}, mjINT_RK4),
      ElementsAre(kFirst, kTrial, kTrial, kTrial, kNextStep, kTrial, kTrial, kTrial, kNextStep));
}

TEST(StepWatch, KnowsTheStartOfARungeKuttaStepAfterForwardDynamics) {
  EXPECT_THAT(See({0, 0, 0.5, 0.5, 1, 1, 1, 1.5, 1.5, 2, 2}, mjINT_RK4),
              ElementsAre(kFirst, kSameInstant, kTrial, kTrial, kTrial, kNextStep, kSameInstant,
                          kTrial, kTrial, kTrial, kNextStep));
}

TEST(StepWatch, AcceptsOneStepPerTimeStepAfterARungeKuttaStepThatBrokeOff) {
  EXPECT_THAT(See({0, 0.5, 0, 0.5, 0.5, 1, 1}, mjINT_RK4),
              ElementsAre(kFirst, kTrial, kSameInstant, kTrial, kTrial, kTrial, kNextStep))
      << "put back";
  const std::vector<StepEvent> left_there =
      See({0, 0.5, /**/ 0.5, 1, 1, 1.5, /**/ 1.5, 2, 2, 2.5, /**/ 2.5, 3, 3, 3.5}, mjINT_RK4);
  EXPECT_EQ(std::count(left_there.begin(), left_there.end(), kNextStep), 3);
  EXPECT_THAT(left_there, Not(Contains(kJump)));
}

TEST(StepWatch, TellsResetsAndJumps) {
  EXPECT_THAT(See({0, 1, 0, 1, 3, 4}),
              ElementsAre(kFirst, kNextStep, kBack, kNextStep, kJump, kNextStep));
}

TEST(StepWatch, TellsStepsThatItWasNotAskedFor) {
  ByHand asked;
  EXPECT_FALSE(asked.watch.HasMissed(0));
  EXPECT_TRUE(asked.watch.HasMissed(1));
  asked.See(5);
  EXPECT_FALSE(asked.watch.HasMissed(6)) << "the end of a step that was asked for at its start";
  EXPECT_TRUE(asked.watch.HasMissed(7));
  EXPECT_FALSE(asked.watch.HasMissed(0)) << "a reset";
}

TEST(StepWatch, TakesDifferencesFromOneStateForTrialsWhateverTheTime) {
  ByHand asked;
  EXPECT_EQ(asked.SeeMoved(0), kFirst);
  EXPECT_EQ(asked.SeeMoved(1), kNextStep);
  EXPECT_EQ(asked.SeeVelocity(2, 0, 0.5 + 1e-6), kTrial);
  EXPECT_EQ(asked.SeeVelocity(3, 6, 0.5 - 1e-6), kTrial);
  EXPECT_EQ(asked.SeePosition(4, 2), kTrial);
  EXPECT_EQ(asked.SeePosition(5, 7), kTrial);
  EXPECT_EQ(asked.See(6), kSameInstant) << "the step that counts, at a time that ran on";
  EXPECT_EQ(asked.SeeMoved(7), kNextStep);
}

TEST(StepWatch, TakesDifferencesAtRestForTrials) {
  ByHand asked;
  mju_zero(asked.d->qvel, asked.m->nv);
  EXPECT_EQ(asked.See(0), kFirst);
  EXPECT_EQ(asked.SeeVelocity(1, 4, 1e-6), kTrial);
  EXPECT_EQ(asked.SeeVelocity(2, 6, 1e-6), kTrial);
  EXPECT_EQ(asked.SeePosition(3, 0), kTrial);
  EXPECT_EQ(asked.See(4), kSameInstant);
}

TEST(StepWatch, FindsTheTimeAfterStepsThatDifferInAControlAlone) {
  ByHand asked;
  EXPECT_EQ(asked.See(0), kFirst);
  EXPECT_EQ(asked.See(3), kSameInstant);
  EXPECT_EQ(asked.SeeMoved(4), kNextStep);
}

TEST(StepWatch, FindsTheTimeAfterRungeKuttaStepsThatDifferInAControlAlone) {
  ByHand asked;
  asked.m->opt.integrator = mjINT_RK4;
  const std::vector<double> start(asked.d->qpos, asked.d->qpos + asked.m->nq);
  EXPECT_EQ(asked.See(0), kFirst);
  for (const double time : {0.5, 0.5, 1.0, /**/ 1.5, 1.5, 2.0, /**/ 2.5, 2.5, 3.0}) {
    EXPECT_EQ(asked.SeeMoved(time), kTrial) << time;
  }
  mju_copy(asked.d->qpos, start.data(), asked.m->nq);
  EXPECT_EQ(asked.See(3), kSameInstant);
}

TEST(StepWatch, AcceptsAStepWhereInDoubt) {
  ByHand asked;
  EXPECT_EQ(asked.See(0), kFirst);
  EXPECT_EQ(asked.See(1), kNextStep) << "a state that is held";
  EXPECT_EQ(asked.SeePosition(2, 2), kNextStep) << "differences do not begin with positions";
  mju_zero(asked.d->qacc, asked.m->nv);
  EXPECT_EQ(asked.SeeMoved(3), kNextStep);
  EXPECT_EQ(asked.SeeVelocity(4, 0, 0.6), kNextStep) << "no acceleration, no motion to miss";
  EXPECT_EQ(asked.See(5), kNextStep);
  EXPECT_EQ(asked.See(7), kJump) << "at rest, or is it?";
}

TEST(StepWatch, AcceptsAStepInWhichNothingMovesYet) {
  ByHand asked;
  mju_zero(asked.d->qvel, asked.m->nv);
  EXPECT_EQ(asked.SeeMoved(0), kFirst);
  EXPECT_EQ(asked.SeeVelocity(1, 1, 1e-30), kNextStep);
}

// What no model does by itself; a host that insists is to hear of it.
TEST(StepWatch, TakesNoMoreStatesForTrialsThanDifferencesHave) {
  ByHand asked;
  asked.See(0);
  std::vector<StepEvent> events;
  for (int i = 1; i <= 4 * asked.m->nv; ++i) {
    events.push_back(asked.SeeVelocity(i, 6, 0.5 + 0.1 * i));
  }
  EXPECT_EQ(asked.SeeVelocity(4 * asked.m->nv + 1, 6, 9), kJump);
  EXPECT_THAT(events, Each(kTrial));
}

TEST(StepWatch, IsAValue) {
  ByHand asked;
  asked.SeeMoved(0);
  asked.SeeVelocity(1, 0, 0.6);
  StepWatch copy = asked.watch;
  EXPECT_EQ(asked.SeeMoved(5), kJump);
  asked.SeeMoved(0);
  std::swap(copy, asked.watch);
  EXPECT_EQ(asked.SeeVelocity(2, 1, 0.6), kTrial);
}

}  // namespace
}  // namespace softsoil
