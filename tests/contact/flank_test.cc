// A tire that slides sideways pushes the soil beside it.
#include "contact/flank.h"

#include <gtest/gtest.h>

#include <cmath>

#include "terrain/constants.h"
#include "terrain/earth_pressure.h"
#include "tests/contact/soil_bin.h"

namespace softsoil {
namespace {

Surface LevelSurface() { return Surface(0.05, SurfaceMode::kFlow, Level); }

// Forces on a tire 8 cm deep in level ground after it has slid for a second.
PatchForces Sliding(const Tire& tire, double v_x, double v_y) {
  WheelContact wheel(tire, 0.05);
  TirePose pose = PressedIn(tire, 0.08);
  pose.velocity_w = {v_x, v_y, 0};
  PatchForces forces;
  wheel.Evaluate(pose, LevelSurface(), TilledLoam(), 1, &forces);
  return forces;
}

double Sideways(const PatchForces& forces) {
  double sum = 0;
  for (const NodeContact& c : forces.contacts) sum += c.flank_force_w.y();
  return sum;
}

TEST(Flank, BearsThePassivePressureOfTheSoilBesideIt) {
  const Tire tire = TruckTire();
  const PatchForces forces = Sliding(tire, 0, 1);
  // Density 1200.2 kg/m^3, cohesion 7.1 kPa, friction angle 21.17 degrees: 2.75 on every node of
  // the left edge, as long as the circumference has nodes, below ground of height 0.
  const double n_phi = std::pow(std::tan((45 + 21.17 / 2) * kPi / 180), 2);
  const double length =
      2 * kPi * tire.shape.radius / std::lround(2 * kPi * tire.shape.radius / 0.05);
  double edge = -1, expected = 0;
  for (const NodeContact& c : forces.contacts) edge = std::max(edge, c.point_w.y());
  for (const NodeContact& c : forces.contacts) {
    if (c.point_w.y() < edge - 0.01) continue;
    const double Z = -c.point_w.z();
    expected += length * (1200.2 * 9.81 * n_phi * Z * Z / 2 + 2 * 7100 * Z * std::sqrt(n_phi));
  }
  ASSERT_GT(expected, 100);
  EXPECT_NEAR(Sideways(forces) / -expected, 1, 1e-9);
}

TEST(Flank, IsInTheWrenchAndOnTheGround) {
  const PatchForces forces = Sliding(TruckTire(), 0.3, 1);
  Eigen::Vector3d on_wheel(0, 0, 0), on_ground(0, 0, 0);
  for (const NodeContact& c : forces.contacts) {
    on_wheel += c.normal_force_w + c.shear_force_w + c.flank_force_w;
  }
  for (const SurfaceForce& f : forces.surface) on_ground += f.force_w;
  EXPECT_LT(Sideways(forces), -100);
  EXPECT_NEAR((on_wheel - forces.wrench.force_w).norm(), 0, 1e-9);
  EXPECT_NEAR((on_ground + forces.wrench.force_w).norm(), 0, 1e-9);
}

TEST(Flank, DoesNotActOnAWheelThatGoesStraight) {
  EXPECT_EQ(Sideways(Sliding(TruckTire(), 1, 0)), 0);
  for (const NodeContact& c : Sliding(AgriculturalTire(), 1, 0).contacts) {
    EXPECT_EQ(c.flank_force_w.norm(), 0);
  }
}

TEST(Flank, HasNothingToPushWhereTheGroundBesideLiesLower) {
  const Tire tire = TruckTire();
  WheelContact wheel(tire, 0.05);
  // A ridge as wide as the tread.
  const Surface ridge(0.05, SurfaceMode::kFlow,
                      [](double, double y) { return std::abs(y) < 0.18 ? 0.0 : -0.5; });
  TirePose pose = PressedIn(tire, 0.08);
  pose.velocity_w = {0, 1, 0};
  PatchForces forces;
  wheel.Evaluate(pose, ridge, TilledLoam(), 1, &forces);
  ASSERT_FALSE(forces.contacts.empty());
  EXPECT_NEAR(Sideways(forces), 0, 1);
}

// Lateral force of a wheel that rolls freely, at a slip angle, under a load; its limit besides.
struct Lateral {
  double force, limit;
};
Lateral AtSlipAngle(double angle) {
  const Tire tire = TruckTire();
  const Soil soil = TilledLoam();
  SoilBinSettings settings;
  settings.tire = tire;
  settings.load = 6000;
  SoilBin bin(settings);
  bin.Drive(0.5, 0, 0);
  bin.pose().velocity_w.y() = std::sin(angle);
  bin.Drive(0.8, std::cos(angle), 0);
  Lateral lateral{bin.forces().wrench.force_w.y(), 0};
  for (const NodeContact& c : bin.forces().contacts) {
    lateral.limit += c.area * soil.shear.cohesion +
                     c.normal_force_w.norm() * std::tan(soil.shear.friction_angle);
  }
  // The berm: no higher above the lowest point of the tread than the ground, on no more than twice
  // the radius.
  double lowest = 0;
  for (const NodeContact& c : bin.forces().contacts) lowest = std::min(lowest, c.point_w.z());
  lateral.limit +=
      2 * tire.shape.radius * PassiveForce(soil.shear, UnitWeight(soil), 0.02 - lowest);
  return lateral;
}

TEST(LateralForce, IsSmoothAndOddInTheSlipAngleAndLimited) {
  double before = 0;
  for (const double degrees : {0.0, 3.0, 6.0, 10.0, 20.0, 40.0, 65.0, 90.0}) {
    SCOPED_TRACE(degrees);
    const Lateral left = AtSlipAngle(degrees * kPi / 180),
                  right = AtSlipAngle(-degrees * kPi / 180);
    EXPECT_NEAR(left.force, -right.force, 1e-6 * 6000);
    EXPECT_LE(left.force, 1);
    EXPECT_GT(left.force, -left.limit);
    EXPECT_LT(left.force, before + 0.1 * 6000);             // does not fall back much
    EXPECT_LT(std::abs(left.force - before), 0.45 * 6000);  // and does not jump
    before = left.force;
  }
  EXPECT_LT(before, -0.4 * 6000);
}

}  // namespace
}  // namespace softsoil
