#include "plugin/step_watch.h"

#include <gmock/gmock.h>

#include <vector>

#include "tests/plugin/mjcf.h"

namespace softsoil {
namespace {

using testing::Each;
using testing::ElementsAre;

constexpr StepEvent kFirst = StepEvent::kFirst, kNextStep = StepEvent::kNextStep,
                    kSameInstant = StepEvent::kSameInstant, kTrial = StepEvent::kTrial,
                    kBack = StepEvent::kBack, kJump = StepEvent::kJump;

std::vector<StepEvent> See(const std::vector<double>& times, double h) {
  StepWatch watch;
  std::vector<StepEvent> events;
  for (const double time : times) events.push_back(watch.See(time, h));
  return events;
}

TEST(StepWatch, AcceptsOneStepPerTimeStep) {
  EXPECT_THAT(See({0, 1, 2}, 1), ElementsAre(kFirst, kNextStep, kNextStep));
}

TEST(StepWatch, TakesTheStagesOfRungeKuttaForTrials) {
  EXPECT_THAT(
      See({0, 0.5, 0.5, 1, 1, 1.5, 1.5, 2}, 1),
      ElementsAre(kFirst, kTrial, kTrial, kNextStep, kSameInstant, kTrial, kTrial, kNextStep));
}

TEST(StepWatch, TellsResetsAndJumps) {
  EXPECT_THAT(See({0, 1, 0, 1, 3, 4}, 1),
              ElementsAre(kFirst, kNextStep, kBack, kNextStep, kJump, kNextStep));
}

TEST(StepWatch, TellsStepsThatItWasNotAskedFor) {
  StepWatch watch;
  EXPECT_FALSE(watch.HasMissed(0));
  EXPECT_TRUE(watch.HasMissed(1));
  watch.See(5, 1);
  EXPECT_FALSE(watch.HasMissed(6)) << "the end of a step that was asked for at its start";
  EXPECT_TRUE(watch.HasMissed(7));
  EXPECT_FALSE(watch.HasMissed(0)) << "a reset";
}

// Counts accepted steps inside MuJoCo.
struct Counter {
  StepWatch watch;
  int accepted = 0;
  std::vector<StepEvent> odd;  // neither expected in a plain run
};
Counter* counter = nullptr;

void Count(const mjModel* m, mjData* d) {
  const StepEvent event = counter->watch.See(d->time, m->opt.timestep);
  if (event == kNextStep) ++counter->accepted;
  if (event == kBack || event == kJump) counter->odd.push_back(event);
}

TEST(StepWatch, CountsEveryStepOfEveryIntegratorOnceInMujoco) {
  const std::string body = R"(<body><freejoint/><geom size=".1"/></body>)";
  for (const char* integrator : {"Euler", "implicit", "RK4"}) {
    const Model m = Load(
        World(body, "<option timestep=\"0.003\" integrator=\"" + std::string(integrator) + "\"/>"));
    const Data d = MakeData(m);
    Counter counts;
    counter = &counts;
    const mjfGeneric before = std::exchange(mjcb_passive, &Count);
    for (int step = 0; step < 1000; ++step) {
      mj_step(m.get(), d.get());
      if (step % 7 == 0) mj_forward(m.get(), d.get());
    }
    mj_forward(m.get(), d.get());
    mjcb_passive = before;
    EXPECT_EQ(counts.accepted, 1000) << integrator;
    EXPECT_TRUE(counts.odd.empty()) << integrator;
    ExpectNoWarnings(d);
  }
}

}  // namespace
}  // namespace softsoil
