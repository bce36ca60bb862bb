// Soft soil inside MuJoCo, seen from the outside.
#include <gmock/gmock.h>

#include <functional>
#include <thread>
#include <vector>

#include "tests/plugin/simulation.h"

namespace softsoil {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(SoftSoil, CarriesTheWeightOfASettledWheel) {
  Simulation sim{OneWheel{}};
  sim.Run(2);
  EXPECT_NEAR(sim.Wheel().load, kOneWheelWeight, 0.01 * kOneWheelWeight);
  EXPECT_NEAR(sim.Row()[2], kOneWheelWeight, 0.01 * kOneWheelWeight);
  EXPECT_GT(sim.Wheel().sinkage, 0.005);
  EXPECT_LT(sim.Height(), -0.005);
  EXPECT_EQ(sim.Height(2), 0);
}

TEST(SoftSoil, GivesTheSameSinkageUnderEveryIntegrator) {
  std::vector<double> sinkage;
  for (const char* integrator : {"Euler", "implicit", "RK4"}) {
    OneWheel model;
    model.option = "integrator=\"" + std::string(integrator) + "\"";
    Simulation sim(model);
    sim.d->qvel[0] = 1;
    sim.d->qvel[2] = 2.5;
    sim.Run(1);
    sinkage.push_back(sim.Wheel().sinkage);
  }
  EXPECT_GT(sinkage[0], 0.005);
  EXPECT_NEAR(sinkage[1], sinkage[0], 0.02 * sinkage[0]);
  EXPECT_NEAR(sinkage[2], sinkage[0], 0.02 * sinkage[0]);
}

TEST(SoftSoil, IsNotChangedByTrialEvaluations) {
  Simulation asked{OneWheel{}}, not_asked{OneWheel{}};
  for (Simulation* sim : {&asked, &not_asked}) {
    sim->Run(0.3);
    if (sim == &asked) {
      for (int i = 0; i < 100; ++i) mj_forward(sim->m.get(), sim->d.get());
    }
    sim->Run(0.3);
  }
  EXPECT_GT(asked.Wheel().sinkage, 0.005);
  EXPECT_EQ(asked.d->qpos[1], not_asked.d->qpos[1]);
  EXPECT_EQ(asked.Height(), not_asked.Height());
}

TEST(SoftSoil, IsUndisturbedAfterAReset) {
  Simulation sim{OneWheel{}};
  sim.Run(0.5);
  const double first_run = sim.d->qpos[1];
  ASSERT_LT(sim.Height(), -0.005);
  mj_resetData(sim.m.get(), sim.d.get());
  mj_forward(sim.m.get(), sim.d.get());
  EXPECT_EQ(sim.Height(), 0);
  sim.Run(0.5);
  EXPECT_EQ(sim.d->qpos[1], first_run);
}

TEST(SoftSoil, IsUndisturbedWhenTimeRunsBackwardsAndSaysSo) {
  Simulation sim{OneWheel{}};
  const auto go_back_to = [&sim](double time) {
    testing::internal::CaptureStderr();
    sim.d->time = time;
    mj_forward(sim.m.get(), sim.d.get());
    return testing::internal::GetCapturedStderr();
  };
  sim.Run(0.2);
  EXPECT_EQ(go_back_to(0), "") << "as in a plain reset";
  sim.Run(0.2);
  ASSERT_EQ(softsoil_reset(sim.m.get(), sim.d.get()), 0);
  EXPECT_EQ(go_back_to(0.1), "") << "the soil knows no time before";
  sim.Run(0.2);
  ASSERT_LT(sim.Height(), -0.005);
  EXPECT_EQ(go_back_to(0.1),
            "softsoil: warning: time ran backwards, but not to 0 s: the ground is undisturbed "
            "again\n");
  EXPECT_EQ(sim.Height(), 0);
}

TEST(SoftSoil, KeepsItsRutWhenTimeLeapsAhead) {
  Simulation sim{OneWheel{}};
  sim.Run(0.5);
  const double height = sim.Height();
  sim.d->time += 1;
  mj_forward(sim.m.get(), sim.d.get());
  EXPECT_EQ(sim.Height(), height);
}

TEST(SoftSoil, AppliesTheSameForceInHostsThatClearNeverClearOrPerturb) {
  const auto settle = [](const std::function<void(Simulation&)>& before_step) {
    Simulation sim{OneWheel{}};
    sim.Run(1, [&] { before_step(sim); });
    return std::vector<double>(sim.d->qpos, sim.d->qpos + sim.m->nq);
  };
  const auto never_clears = settle([](Simulation&) {});
  const auto clears = settle([](Simulation& sim) { mju_zero(sim.Row(), 6); });
  EXPECT_EQ(clears, never_clears);

  const auto writes_push = settle([](Simulation& sim) {
    mju_zero(sim.Row(), 6);
    sim.Row()[2] = 100;
  });
  const auto pushed_once = settle([](Simulation& sim) {
    if (sim.d->time == 0) sim.Row()[2] = 100;
  });
  EXPECT_EQ(writes_push, pushed_once);
  EXPECT_GT(writes_push[1], never_clears[1]) << "lifted by 100 N";
}

TEST(SoftSoil, KeepsTheForceOfTheMouse) {
  Simulation sim{OneWheel{}};
  sim.Run(0.5);
  mjvPerturb mouse;
  mjv_defaultPerturb(&mouse);
  mouse.select = sim.WheelBody();
  mouse.active = mjPERT_TRANSLATE;
  mju_copy3(mouse.refpos, sim.d->xpos + 3 * mouse.select);
  mouse.refpos[2] += 0.1;
  mouse.refquat[0] = 1;
  mouse.scale = 1;
  mjv_applyPerturbForce(sim.m.get(), sim.d.get(), &mouse);
  const double mouse_force = sim.Row()[2];
  ASSERT_GT(mouse_force, 0);
  mj_forward(sim.m.get(), sim.d.get());
  EXPECT_NEAR(sim.Row()[2], mouse_force + sim.Wheel().load, 1e-9 * kOneWheelWeight);
}

TEST(SoftSoil, TakesOutRigidContactOnRequest) {
  OneWheel model;
  model.plane = "";
  Simulation rigid(model);
  rigid.Run(0.5);
  EXPECT_GT(rigid.d->ncon, 0);

  model.custom += R"(<text name="softsoil_rigid_contact" data="remove"/>)";
  Simulation soft(model);
  soft.Run(0.5);
  EXPECT_EQ(soft.d->ncon, 0);
  EXPECT_LT(soft.Height(), -0.005);
  softsoil_detach(soft.m.get(), soft.d.get());
  mj_forward(soft.m.get(), soft.d.get());
  EXPECT_GT(soft.d->ncon, 0) << "after detaching the plane is rigid again";
}

TEST(SoftSoil, RollsAWheelForwardWithPositiveSpin) {
  Simulation sim{OneWheel{}};
  sim.d->qvel[0] = 1;
  sim.d->qvel[2] = 2.5;
  sim.Run(0.2);
  EXPECT_GT(sim.Wheel().forward_speed, 0.5);
  EXPECT_GT(sim.Wheel().spin, 1);
  EXPECT_NEAR(sim.Wheel().slip_angle, 0, 1e-6);
  EXPECT_NEAR(sim.Wheel().camber, 0, 1e-6);
}

TEST(SoftSoil, HasTheSameBitsInTwoThreadsAsInOne) {
  OneWheel model;
  model.custom = R"(<text name="softsoil_soil" data="tilled_yolo_loam"/>
                    <numeric name="softsoil_threads" data="2"/>)";
  const auto drive = [](Simulation& sim, double speed) {
    sim.d->qvel[0] = speed;
    sim.Run(0.5);
  };
  Simulation a(model), b(model), alone_a(model), alone_b(model);
  std::thread first([&] { drive(a, 0.5); });
  std::thread second([&] { drive(b, 1); });
  first.join();
  second.join();
  drive(alone_a, 0.5);
  drive(alone_b, 1);
  EXPECT_NE(a.d->qpos[0], b.d->qpos[0]);
  for (int k = 0; k < a.m->nq; ++k) {
    EXPECT_EQ(a.d->qpos[k], alone_a.d->qpos[k]);
    EXPECT_EQ(b.d->qpos[k], alone_b.d->qpos[k]);
  }
}

TEST(SoftSoil, OutlivesASimulationThatDiverges) {
  Model m = Load(OneWheel{}.Mjcf());
  Data d = MakeData(m);
  ASSERT_EQ(softsoil_attach(m.get(), d.get(), nullptr), 0);
  for (int i = 0; i < 100; ++i) mj_step(m.get(), d.get());
  d->qvel[1] = mjMAXVAL / 10;  // MuJoCo lets it pass, then resets by itself
  for (int i = 0; i < 1500; ++i) mj_step(m.get(), d.get());
  softsoilWheel wheel;
  ASSERT_EQ(softsoil_wheel(d.get(), 0, &wheel), 0);
  EXPECT_NEAR(wheel.load, kOneWheelWeight, 0.02 * kOneWheelWeight);

  d->qpos[1] = std::nan("");
  mj_forward(m.get(), d.get());
  for (int k = 0; k < 6; ++k) EXPECT_EQ(d->xfrc_applied[6 * wheel.body + k], 0);
}

TEST(SoftSoil, LeavesNothingBehindWhenItIsDetached) {
  Simulation sim{OneWheel{}};
  sim.Run(0.5);
  ASSERT_EQ(softsoil_detach(sim.m.get(), sim.d.get()), 0);
  for (int k = 0; k < 6; ++k) EXPECT_EQ(sim.Row()[k], 0);
  EXPECT_EQ(softsoil_wheel_count(sim.d.get()), -1);
  sim.Run(0.01);
  EXPECT_EQ(sim.Row()[2], 0);
}

TEST(SoftSoil, IsGivenBackWithItsMjData) {
  const Model m = Load(OneWheel{}.Mjcf());
  const mjData* address = nullptr;
  {
    const Data d = MakeData(m);
    address = d.get();
    ASSERT_EQ(softsoil_attach(m.get(), d.get(), nullptr), 0);
    ASSERT_EQ(softsoil_wheel_count(address), 1);
  }
  EXPECT_EQ(softsoil_wheel_count(address), -1);
}

std::string Warnings(const OneWheel& model) {
  testing::internal::CaptureStderr();
  { Simulation sim(model); }
  return testing::internal::GetCapturedStderr();
}

TEST(SoftSoil, WarnsOfATimeStepTooLong) {
  OneWheel model;
  EXPECT_THAT(Warnings(model), Not(HasSubstr("the time step")));
  model.timestep = "0.1";
  EXPECT_THAT(Warnings(model),
              HasSubstr("warning: the time step 0.1 s is more than half of about"));
}

TEST(SoftSoil, WarnsOfAGridTooCoarseForTheWheel) {
  OneWheel model;
  model.custom += R"(<numeric name="softsoil_grid_spacing" data="0.15"/>)";
  EXPECT_THAT(Warnings(model), HasSubstr("warning: softsoil_grid_spacing is 0.15 m, more than a "
                                         "quarter of the smallest wheel radius, 0.4 m"));
}

TEST(SoftSoil, WarnsOfATireOfAnotherSizeThanItsGeom) {
  OneWheel model;
  model.custom += R"(<text name="softsoil_tire" data="18.4R38_85kPa"/>)";
  EXPECT_THAT(Warnings(model), HasSubstr("warning: wheel \"wheel\": tire \"18.4R38_85kPa\" has "
                                         "the radius 0.91 m, the wheel's geom 0.4 m"));
}

}  // namespace
}  // namespace softsoil
