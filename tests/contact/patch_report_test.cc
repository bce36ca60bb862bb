// Signs after TYDEX: ahead is the way the vehicle faces, left is to its left.
#include "contact/patch_report.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "tests/contact/ground_samples.h"
#include "tests/contact/samples.h"

namespace softsoil {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kPressedIn = 0.06;  // [m]

// A tire that has moved like this for 0.2 s.
struct Patch {
  Tire tire = AgriculturalTire();
  Soil soil = TilledLoam();
  UndisturbedHeight ground = Level;
  TirePose pose = PressedIn(tire, kPressedIn);
  TireNodes nodes = MakeTireNodes(tire.shape, 0.04);
  PatchForces forces;

  Patch& Moving(double speed, double left, double slip) {
    pose.velocity_w = pose.frame_w * Vector3d(speed, left, 0);
    pose.angular_velocity_w = pose.frame_w.col(1) * speed * (1 + slip) / tire.shape.radius;
    return *this;
  }
  // Turned with the world about the origin.
  Patch& Turned(const Matrix3d& rotation) {
    pose = Rotated(rotation, pose);
    return *this;
  }
  std::vector<PatchPoint> Report() {
    const Surface surface(0.05, SurfaceMode::kFlow, ground);
    WheelContact(tire, 0.04).Evaluate(pose, surface, soil, 0.2, &forces);
    const std::vector<PatchPoint> points = PatchReportOf(nodes, pose, forces);
    EXPECT_GT(points.size(), 20u);
    return points;
  }
};

void ExpectSamePatch(const std::vector<PatchPoint>& a, const std::vector<PatchPoint>& b,
                     double error) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_NEAR(a[i].angle, b[i].angle, error);
    EXPECT_NEAR(a[i].lateral, b[i].lateral, error);
    EXPECT_NEAR(a[i].area, b[i].area, error);
    EXPECT_NEAR(a[i].pressure, b[i].pressure, error * 1e5);
    EXPECT_NEAR(a[i].shear, b[i].shear, error * 1e5);
    EXPECT_NEAR(a[i].shear_across, b[i].shear_across, error * 1e5);
  }
}

TEST(PatchReport, AddsUpToTheForceOnTheWheel) {
  Patch patch;
  Vector3d force = Vector3d::Zero();
  double most = 0;
  for (const PatchPoint& p : patch.Moving(1, 0.3, 0.3).Report()) {
    force += p.normal_force_w + p.shear_force_w + p.flank_force_w;
    const double shear = std::hypot(p.shear, p.shear_across) * p.area;
    EXPECT_NEAR(p.normal_force_w.norm(), p.pressure * p.area, 1e-9 * p.pressure * p.area);
    EXPECT_NEAR(p.shear_force_w.norm(), shear, 1e-9 * shear);
    EXPECT_LE(p.depth, kPressedIn);
    most = std::max(most, p.depth);
  }
  EXPECT_LT(RelativeError(force, patch.forces.wrench.force_w), 1e-12);
  EXPECT_GT(most, kPressedIn / 2);
}

TEST(PatchReport, HasAngleZeroBelowTheAxleAndPositiveAngleAhead) {
  for (double yaw : {0.0, 2.2, -1.1}) {
    for (double speed : {1.0, -1.0}) {
      Patch patch;
      patch.Turned(RotationAbout(Vector3d::UnitZ(), yaw));
      const Vector3d ahead = patch.pose.frame_w.col(0), left = patch.pose.frame_w.col(1);
      double least = 1;
      for (const PatchPoint& p : patch.Moving(speed, 0, 0.3).Report()) {
        const Vector3d from_centre = p.position_w - patch.pose.centre_w;
        EXPECT_NEAR(from_centre.dot(ahead), -std::tan(p.angle) * from_centre.z(), 1e-12);
        EXPECT_NEAR(from_centre.dot(left), p.lateral, 1e-12);
        least = std::min(least, std::abs(p.angle));
      }
      EXPECT_NEAR(least, 0, 1e-9);
    }
  }
}

// The angle belongs to the ground, not to a mark on the tire.
TEST(PatchReport, IsTheSameHoweverFarTheWheelHasTurned) {
  Patch still, turned;
  const auto first = still.Moving(1, 0, 0.3).Report();
  turned.pose.frame_w = RotationAbout(Vector3d::UnitY(), 3.0);
  turned.pose.velocity_w = still.pose.velocity_w;
  turned.pose.angular_velocity_w = still.pose.angular_velocity_w;
  const auto second = turned.Report();
  const auto widest = [](const std::vector<PatchPoint>& points) {
    const auto [least, most] =
        std::minmax_element(points.begin(), points.end(),
                            [](const auto& a, const auto& b) { return a.angle < b.angle; });
    return std::make_pair(least->angle, most->angle);
  };
  const double node = 0.04 / still.tire.shape.radius;
  EXPECT_NEAR(widest(first).first, widest(second).first, node);
  EXPECT_NEAR(widest(first).second, widest(second).second, node);
  EXPECT_LT(widest(second).first, -0.1);
  EXPECT_GT(widest(second).second, 0.1);
}

TEST(PatchReport, HasAShearThatDrivesForwardWhereTheWheelSpinsFaster) {
  for (double speed : {1.0, -1.0}) {
    for (double slip : {0.3, -0.3}) {
      Patch patch;
      for (const PatchPoint& p : patch.Moving(speed, 0, slip).Report()) {
        if (std::abs(p.angle) > 0.1) continue;
        EXPECT_GT(p.shear * speed * slip, 0) << speed << " " << slip;
      }
    }
  }
}

TEST(PatchReport, HasAShearToTheRightWhereTheWheelSlidesToTheLeft) {
  Patch patch;
  for (const PatchPoint& p : patch.Moving(1, 0.5, 0).Report()) EXPECT_LT(p.shear_across, 0);
}

TEST(PatchReport, IsTheSameWhicheverWayTheVehicleFaces) {
  Patch ahead, turned;
  turned.Turned(RotationAbout(Vector3d::UnitZ(), 2.2));
  ExpectSamePatch(turned.Moving(1, 0.3, 0.2).Report(), ahead.Moving(1, 0.3, 0.2).Report(), 1e-9);
}

// On rock, where no gravity and no direction of the sinkage tells slope and level ground apart.
TEST(PatchReport, IsTheSameOnASlopeAsOnLevelGround) {
  Patch level, steep;
  level.soil = steep.soil = Rock();
  level.tire = steep.tire = TruckTire();
  level.nodes = steep.nodes = MakeTireNodes(level.tire.shape, 0.04);
  level.pose = steep.pose = PressedIn(level.tire, 0.03);
  steep.ground = Rising(std::tan(0.3));
  steep.Turned(RotationAbout(Vector3d::UnitY(), -0.3));
  ExpectSamePatch(steep.Moving(1, 0.2, 0.2).Report(), level.Moving(1, 0.2, 0.2).Report(), 1e-6);
}

TEST(PatchReport, IsEmptyInTheAirAndBeforeTheFirstEvaluation) {
  Patch patch;
  EXPECT_TRUE(PatchReportOf(patch.nodes, patch.pose, PatchForces()).empty());
  patch.pose = PressedIn(patch.tire, -0.1);
  const Surface level(0.05, SurfaceMode::kFlow, Level);
  WheelContact(patch.tire, 0.04).Evaluate(patch.pose, level, patch.soil, 0.2, &patch.forces);
  EXPECT_TRUE(PatchReportOf(patch.nodes, patch.pose, patch.forces).empty());
}

}  // namespace
}  // namespace softsoil
