#include "plugin/step_watch.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

#include "tests/plugin/mjcf.h"

namespace softsoil {
namespace {

using testing::Contains;
using testing::Each;
using testing::ElementsAre;
using testing::Not;

constexpr StepEvent kFirst = StepEvent::kFirst, kNextStep = StepEvent::kNextStep,
                    kSameInstant = StepEvent::kSameInstant, kTrial = StepEvent::kTrial,
                    kBack = StepEvent::kBack, kJump = StepEvent::kJump;

// A body that flies, with a wheel on it.
Model Flyer(const std::string& option) {
  return Load(World(R"(<body><freejoint/><geom size=".1"/>
                         <body><joint axis="0 1 0"/><geom size=".1" pos=".3 0 0"/></body>
                       </body>)",
                    "<option " + option + "/>"));
}

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
  EXPECT_EQ(asked.SeeVelocity(1, 0, 1e-6), kTrial);
  EXPECT_EQ(asked.SeePosition(2, 0), kTrial);
  EXPECT_EQ(asked.See(3), kSameInstant);
}

TEST(StepWatch, FindsTheTimeAfterStepsThatDifferInAControlAlone) {
  ByHand asked;
  EXPECT_EQ(asked.See(0), kFirst);
  EXPECT_EQ(asked.See(3), kSameInstant);
  EXPECT_EQ(asked.SeeMoved(4), kNextStep);
}

TEST(StepWatch, AcceptsAStepWhereInDoubt) {
  ByHand asked;
  EXPECT_EQ(asked.See(0), kFirst);
  EXPECT_EQ(asked.See(1), kNextStep) << "a state that is held";
  EXPECT_EQ(asked.SeePosition(2, 2), kNextStep) << "differences do not begin with positions";
  mju_zero(asked.d->qacc, asked.m->nv);
  EXPECT_EQ(asked.SeeMoved(3), kNextStep);
  EXPECT_EQ(asked.SeeVelocity(4, 0, 0.6), kNextStep) << "no acceleration, no motion to miss";
  EXPECT_EQ(asked.See(6), kJump);
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

// Counts accepted steps inside MuJoCo.
struct Counter {
  StepWatch watch;
  int accepted = 0;
  std::vector<StepEvent> odd;  // neither expected in a plain run
};
Counter* counter = nullptr;

void Count(const mjModel* m, mjData* d) {
  const StepEvent event = counter->watch.See(m, d);
  if (event == kNextStep) ++counter->accepted;
  if (event == kBack || event == kJump) counter->odd.push_back(event);
}

using Host = std::function<void(const Model& m, const Data& d, int step)>;

void ExpectEveryStepToCountOnce(const std::function<Model(const std::string& option)>& load,
                                const Host& host) {
  for (const char* integrator : {"Euler", "implicit", "RK4"}) {
    const Model m = load("timestep=\"0.003\" integrator=\"" + std::string(integrator) + "\"");
    const Data d = MakeData(m);
    Counter counts;
    counter = &counts;
    const mjfGeneric before = std::exchange(mjcb_passive, &Count);
    for (int step = 0; step < 1000; ++step) {
      host(m, d, step);
      mj_step(m.get(), d.get());
    }
    host(m, d, 1000);
    mj_forward(m.get(), d.get());
    mjcb_passive = before;
    EXPECT_EQ(counts.accepted, 1000) << integrator;
    EXPECT_TRUE(counts.odd.empty()) << integrator;
    ExpectNoWarnings(d);
  }
}

TEST(StepWatch, CountsEveryStepOfEveryIntegratorOnceInMujoco) {
  ExpectEveryStepToCountOnce(&Flyer, [](const Model& m, const Data& d, int step) {
    if (step % 7 == 0) mj_forward(m.get(), d.get());
  });
}

TEST(StepWatch, CountsStepsBetweenDifferencesOnce) {
  ExpectEveryStepToCountOnce(&Flyer, [](const Model& m, const Data& d, int step) {
    if (step == 0) d->qvel[4] = 1;
    std::vector<double> a(4 * m->nv * m->nv);
    mjd_transitionFD(m.get(), d.get(), 1e-6, step % 2, a.data(), nullptr, nullptr, nullptr);
  });
}

TEST(StepWatch, CountsStepsOnceWhileTheHostHoldsThePositions) {
  ExpectEveryStepToCountOnce(&Flyer, [](const Model& m, const Data& d, int step) {
    if (step == 0) std::fill_n(d->qvel, m->nv, 0.5);
    mju_copy(d->qpos, m->qpos0, m->nq);
  });
}

TEST(StepWatch, CountsStepsOnceWhileTheHostHoldsPositionsAndVelocities) {
  for (const double velocity : {0.0, 0.5}) {
    ExpectEveryStepToCountOnce(&Flyer, [=](const Model& m, const Data& d, int) {
      std::fill_n(d->qvel, m->nv, velocity);
      mju_copy(d->qpos, m->qpos0, m->nq);
    });
  }
}

TEST(StepWatch, CountsStepsOnceWhileTheHostHoldsAllButTheWheel) {
  ExpectEveryStepToCountOnce(&Flyer, [](const Model& m, const Data& d, int) {
    mju_copy(d->qpos, m->qpos0, 7);
    mju_zero(d->qvel, 6);
  });
}

TEST(StepWatch, CountsStepsOnceWhileTheHostMovesOneJoint) {
  for (const double velocity : {0.0, 0.5}) {
    ExpectEveryStepToCountOnce(&Flyer, [=](const Model& m, const Data& d, int step) {
      mju_copy(d->qpos, m->qpos0, m->nq);
      std::fill_n(d->qvel, m->nv, velocity);
      d->qpos[2] = -1e-6 * step;
    });
  }
}

TEST(StepWatch, CountsStepsOnceWhileTheHostSetsTheVelocities) {
  ExpectEveryStepToCountOnce(&Flyer, [](const Model& m, const Data& d, int) {
    mju_zero(d->qvel, m->nv);
    d->qvel[6] = 2;
  });
}

TEST(StepWatch, CountsStepsOnceWhereTheHostTeleportsTheModel) {
  ExpectEveryStepToCountOnce(&Flyer, [](const Model&, const Data& d, int step) {
    if (step % 5 == 0) d->qpos[0] = step;
  });
}

TEST(StepWatch, CountsStepsOnceWhereTheTimeStepChanges) {
  ExpectEveryStepToCountOnce(&Flyer, [](const Model& m, const Data&, int step) {
    m->opt.timestep = step % 3 == 0 ? 0.001 : 0.004;
  });
}

TEST(StepWatch, CountsStepsOnceOfAModelAtRest) {
  const auto load = [](const std::string& option) { return Flyer(R"(gravity="0 0 0" )" + option); };
  ExpectEveryStepToCountOnce(load, [](const Model&, const Data&, int) {});
}

TEST(StepWatch, CountsStepsOnceOfAWheelThatSpinsFreely) {
  const auto load = [](const std::string& option) {
    return Load(World(R"(<body><joint type="slide" axis="0 0 1"/><geom size=".1"/>
                           <body><joint axis="0 1 0"/><geom size=".1"/></body>
                         </body>)",
                      R"(<option gravity="0 0 0" )" + option + "/>"));
  };
  ExpectEveryStepToCountOnce(load, [](const Model&, const Data& d, int step) {
    if (step == 0) d->qvel[1] = 3;
  });
}

TEST(StepWatch, CountsStepsOnceOfAModelWithASingleJoint) {
  const auto load = [](const std::string& option) {
    return Load(World(R"(<body><joint axis="0 1 0"/><geom size=".1" pos=".3 0 0"/></body>)",
                      "<option " + option + "/>"));
  };
  ExpectEveryStepToCountOnce(load, [](const Model&, const Data&, int) {});
}

TEST(StepWatch, CountsStepsOnceOfBodiesThatFollowAMocapBody) {
  const auto load = [](const std::string& option) {
    return Load(
        World(R"(<body name="hand" mocap="true"><geom size=".1" contype="0"/></body>
                         <body name="load"><freejoint/><geom size=".1" contype="0"/></body>)",
              "<option " + option + R"(/><equality><weld body1="hand" body2="load"/></equality>)"));
  };
  ExpectEveryStepToCountOnce(
      load, [](const Model&, const Data& d, int step) { d->mocap_pos[0] = 1e-4 * step; });
}

}  // namespace
}  // namespace softsoil
