// Wheels on the bumps of softsoil_bumps.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "terrain/nurbs_bumps.h"
#include "tests/plugin/simulation.h"

namespace softsoil {
namespace {

constexpr NurbsBumps kBumps = {0.1, 1.5, 14};
constexpr double kTop = 1.6, kHollow = 5;  // [m]  x of the highest and lowest of the first metres
constexpr char kSetting[] = "bumps=0.1,1.5,14";

OneWheel Inclined(double degrees) {
  OneWheel model;
  model.plane += " euler=\"0 " + std::to_string(-degrees) + " 0\"";
  return model;
}

TEST(BumpyGround, HasTheHeightOfTheBumpsAboveThePlane) {
  for (double degrees : {0.0, 10.0}) {
    const Simulation sim(Inclined(degrees), kSetting);
    const double slope = std::tan(degrees * mjPI / 180);
    for (const double x : {0.0, 0.4, -5.025, 300.0}) {  // on grid nodes
      EXPECT_NEAR(sim.Height(x), slope * x + HeightOf(kBumps, x, 0), 1e-9) << x;
    }
  }
}

TEST(BumpyGround, HasOtherBumpsWhereASettingSaysSo) {
  const Simulation sim(OneWheel{}, kSetting), other(OneWheel{}, "bumps=0.1,1.5,15");
  EXPECT_NE(sim.Height(), other.Height());
}

// The wheel alone may not roll: it is held at a place along x, where it comes to rest.
softsoilWheel AtRest(Simulation* sim, double x) {
  sim->d->qpos[0] = x;
  sim->d->qpos[1] = 0.2;
  sim->Run(1, [sim, x] {
    sim->d->qpos[0] = x;
    sim->d->qvel[0] = sim->d->qvel[2] = 0;
  });
  return sim->Wheel();
}

TEST(BumpyGround, CarriesAWheelOnTopOfTheBumpsAndMeasuresSinkageFromThem) {
  Simulation flat{OneWheel{}};
  const softsoilWheel level = AtRest(&flat, 0);
  ASSERT_GT(level.sinkage, 0.01);
  ASSERT_GT(HeightOf(kBumps, kTop, 0) - HeightOf(kBumps, kHollow, 0), 0.1);
  for (const double x : {kTop, kHollow}) {
    Simulation sim(OneWheel{}, kSetting);
    const softsoilWheel wheel = AtRest(&sim, x);
    const double bump = HeightOf(kBumps, x, 0);
    EXPECT_NEAR(wheel.force[2] / kOneWheelWeight, 1, 1e-3);
    // Crowns and hollows 1.5 m apart are nearly level for a wheel of 0.4 m radius.
    EXPECT_NEAR(wheel.centre[2] - bump, level.centre[2], 0.002) << x;
    EXPECT_NEAR(wheel.sinkage, level.sinkage, 0.05 * level.sinkage) << x;
    EXPECT_NEAR(wheel.rut_depth, level.rut_depth, 0.05 * level.sinkage) << x;
  }
}

TEST(BumpyGround, TellsASurfaceThatIsTheBumpsLessTheSinkage) {
  Simulation sim(OneWheel{}, kSetting);
  AtRest(&sim, kTop);
  double deepest = 0;
  softsoil_visit_surface(
      sim.d.get(),
      [](void* user, double x, double y, double height, double sinkage) {
        EXPECT_NEAR(height, HeightOf(kBumps, x, y) - sinkage, 1e-12);
        auto* deepest = static_cast<double*>(user);
        *deepest = std::max(*deepest, sinkage);
      },
      &deepest);
  EXPECT_GT(deepest, 0.01);
}

TEST(BumpyGround, LiftsAWheelThatRollsOverIt) {
  Simulation sim(OneWheel{}, kSetting);
  double highest = -1, lowest = 1;
  sim.d->qpos[1] = HeightOf(kBumps, 0, 0);
  sim.Run(2.7, [&] {
    sim.d->qvel[0] = 2;
    if (sim.d->qpos[0] < 1) return;  // until then it sinks in
    highest = std::max(highest, sim.d->qpos[1]);
    lowest = std::min(lowest, sim.d->qpos[1]);
  });
  EXPECT_GT(highest - lowest, 0.08);
  EXPECT_LT(highest - lowest, 2 * kBumps.height);
}

TEST(BumpyGround, WarnsOfAGridTooCoarseForTheBumps) {
  testing::internal::CaptureStderr();
  { const Simulation sim(OneWheel{}, "bumps=0.01,0.09"); }
  EXPECT_THAT(testing::internal::GetCapturedStderr(),
              testing::HasSubstr("warning: softsoil_grid_spacing is 0.025 m, more than a quarter "
                                 "of the distance of the bumps, 0.09 m; make it finer"));
}

}  // namespace
}  // namespace softsoil
