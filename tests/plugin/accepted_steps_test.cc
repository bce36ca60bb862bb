// Every step of a run in MuJoCo is accepted once, whatever the host does to the state: a step taken
// for a trial by mistake would freeze the soil.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <utility>
#include <vector>

#include "plugin/step_watch.h"
#include "tests/plugin/flyer.h"

namespace softsoil {
namespace {

// Counts accepted steps inside MuJoCo.
struct Counter {
  StepWatch watch;
  int accepted = 0;
  std::vector<StepEvent> odd;  // neither expected in a plain run
};
Counter* counter = nullptr;

void Count(const mjModel* m, mjData* d) {
  const StepEvent event = counter->watch.See(m, d);
  if (event == StepEvent::kNextStep) ++counter->accepted;
  if (event == StepEvent::kBack || event == StepEvent::kJump) counter->odd.push_back(event);
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

TEST(AcceptedSteps, AreCountedOnceUnderEveryIntegrator) {
  ExpectEveryStepToCountOnce(&Flyer, [](const Model& m, const Data& d, int step) {
    if (step % 7 == 0) mj_forward(m.get(), d.get());
  });
}

TEST(AcceptedSteps, AreCountedOnceBetweenDifferences) {
  ExpectEveryStepToCountOnce(&Flyer, [](const Model& m, const Data& d, int step) {
    if (step == 0) d->qvel[4] = 1;
    std::vector<double> a(4 * m->nv * m->nv);
    mjd_transitionFD(m.get(), d.get(), 1e-6, step % 2, a.data(), nullptr, nullptr, nullptr);
  });
}

TEST(AcceptedSteps, AreCountedOnceWhileTheHostHoldsThePositions) {
  ExpectEveryStepToCountOnce(&Flyer, [](const Model& m, const Data& d, int step) {
    if (step == 0) std::fill_n(d->qvel, m->nv, 0.5);
    mju_copy(d->qpos, m->qpos0, m->nq);
  });
}

TEST(AcceptedSteps, AreCountedOnceWhileTheHostHoldsPositionsAndVelocities) {
  for (const double velocity : {0.0, 0.5}) {
    ExpectEveryStepToCountOnce(&Flyer, [=](const Model& m, const Data& d, int) {
      std::fill_n(d->qvel, m->nv, velocity);
      mju_copy(d->qpos, m->qpos0, m->nq);
    });
  }
}

TEST(AcceptedSteps, AreCountedOnceWhileTheHostHoldsAllButTheWheel) {
  ExpectEveryStepToCountOnce(&Flyer, [](const Model& m, const Data& d, int) {
    mju_copy(d->qpos, m->qpos0, 7);
    mju_zero(d->qvel, 6);
  });
}

TEST(AcceptedSteps, AreCountedOnceWhileTheHostMovesOneJoint) {
  for (const double velocity : {0.0, 0.5}) {
    ExpectEveryStepToCountOnce(&Flyer, [=](const Model& m, const Data& d, int step) {
      mju_copy(d->qpos, m->qpos0, m->nq);
      std::fill_n(d->qvel, m->nv, velocity);
      d->qpos[2] = -1e-6 * step;
    });
  }
}

TEST(AcceptedSteps, AreCountedOnceWhileTheHostSetsTheVelocities) {
  ExpectEveryStepToCountOnce(&Flyer, [](const Model& m, const Data& d, int) {
    mju_zero(d->qvel, m->nv);
    d->qvel[6] = 2;
  });
}

TEST(AcceptedSteps, AreCountedOnceWhereTheHostTeleportsTheModel) {
  ExpectEveryStepToCountOnce(&Flyer, [](const Model&, const Data& d, int step) {
    if (step % 5 == 0) d->qpos[0] = step;
  });
}

TEST(AcceptedSteps, AreCountedOnceWhereTheTimeStepChanges) {
  ExpectEveryStepToCountOnce(&Flyer, [](const Model& m, const Data&, int step) {
    m->opt.timestep = step % 3 == 0 ? 0.001 : 0.004;
  });
}

TEST(AcceptedSteps, AreCountedOnceOfAModelAtRest) {
  const auto load = [](const std::string& option) { return Flyer(R"(gravity="0 0 0" )" + option); };
  ExpectEveryStepToCountOnce(load, [](const Model&, const Data&, int) {});
}

TEST(AcceptedSteps, AreCountedOnceOfAWheelThatSpinsFreely) {
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

TEST(AcceptedSteps, AreCountedOnceOfAModelWithASingleJoint) {
  const auto load = [](const std::string& option) {
    return Load(World(R"(<body><joint axis="0 1 0"/><geom size=".1" pos=".3 0 0"/></body>)",
                      "<option " + option + "/>"));
  };
  ExpectEveryStepToCountOnce(load, [](const Model&, const Data&, int) {});
}

TEST(AcceptedSteps, AreCountedOnceOfBodiesThatFollowAMocapBody) {
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
