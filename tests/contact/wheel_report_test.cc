// Signs after TYDEX: x ahead, y to the left, z up; forces of the ground on the wheel.
#include "contact/wheel_report.h"

#include <gtest/gtest.h>

#include "terrain/point_load.h"
#include "tests/contact/ground_samples.h"
#include "tests/contact/samples.h"

namespace softsoil {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

// An upright wheel 6 cm deep in level loam, seen once it has moved like this for 0.2 s.
struct Motion {
  double speed = 0, left = 0, slip = 0;  // [m/s], [m/s], [-]
  Matrix3d attitude = Matrix3d::Identity();

  TirePose Pose() const {
    const Tire tire = TruckTire();
    TirePose pose = PressedIn(tire, 0.06);
    pose.frame_w = attitude;
    pose.velocity_w = attitude * Vector3d(speed, left, 0);
    pose.angular_velocity_w = attitude.col(1) * speed * (1 + slip) / tire.shape.radius;
    return pose;
  }
  WheelReport Report() const {
    const Tire tire = TruckTire();
    const Surface level(0.05, SurfaceMode::kFlow, Level);
    PatchForces forces;
    WheelContact(tire, 0.02).Evaluate(Pose(), level, TilledLoam(), 0.2, &forces);
    return ReportOf(tire, Pose(), forces);
  }
};

TEST(WheelReport, PullsAheadWhenDriven) {
  const WheelReport report = Motion{2, 0, 0.3}.Report();
  EXPECT_NEAR(report.slip_ratio, 0.3, 1e-12);
  EXPECT_NEAR(report.forward_speed, 2, 1e-12);
  EXPECT_NEAR(report.spin, 2 * 1.3 / TruckTire().shape.radius, 1e-12);
  EXPECT_GT(report.thrust, 1000);
  EXPECT_GT(report.torque, 400);
  EXPECT_GT(report.load, 1000);
}

TEST(WheelReport, HoldsBackWhenBraked) {
  const WheelReport report = Motion{2, 0, -0.4}.Report();
  EXPECT_NEAR(report.slip_ratio, -0.4, 1e-12);
  EXPECT_LT(report.thrust, -1000);
  EXPECT_LT(report.torque, -400);
  EXPECT_NEAR((Motion{2, 0, -1}.Report().slip_ratio), -1, 1e-12);  // locked
}

TEST(WheelReport, PullsBackwardsWhenDrivenInReverse) {
  const WheelReport report = Motion{-2, 0, 0.3}.Report();
  EXPECT_NEAR(report.slip_ratio, 0.3, 1e-12);
  EXPECT_LT(report.spin, 0);
  EXPECT_LT(report.thrust, -1000);
  EXPECT_LT(report.torque, -400);
}

TEST(WheelReport, KeepsTheSignOfSlipWhereTheWheelSpinsOnTheSpot) {
  for (double creep : {0.0, 0.001, -0.001}) {
    for (double spin : {5.0, -5.0}) {
      TirePose pose = PressedIn(TruckTire(), 0.06);
      pose.velocity_w.x() = creep;
      pose.angular_velocity_w.y() = spin;
      EXPECT_GT(ReportOf(TruckTire(), pose, PatchForces()).slip_ratio, 100) << creep << " " << spin;
    }
    TirePose locked = PressedIn(TruckTire(), 0.06);
    locked.velocity_w.x() = creep;
    EXPECT_LE(ReportOf(TruckTire(), locked, PatchForces()).slip_ratio, 0) << creep;
  }
}

TEST(WheelReport, HasAPositiveSlipAngleWhenTheWheelSlidesToTheLeft) {
  const WheelReport left = Motion{2, 0.5, 0}.Report();
  EXPECT_NEAR(left.slip_angle, std::atan2(0.5, 2), 1e-12);
  EXPECT_LT(left.lateral_force, -1000);
  const WheelReport right = Motion{-2, -0.5, 0}.Report();  // in reverse, too
  EXPECT_NEAR(right.slip_angle, -std::atan2(0.5, 2), 1e-12);
  EXPECT_GT(right.lateral_force, 1000);
}

TEST(WheelReport, HasAPositiveCamberWhenTheTopLeansToTheRight) {
  const Motion leaning{2, 0, 0, RotationAbout(Vector3d::UnitX(), 0.1)};
  EXPECT_NEAR(leaning.Report().camber, 0.1, 1e-12);
  const Vector3d top = leaning.attitude * Vector3d::UnitZ();
  EXPECT_LT(top.y(), 0);  // y is to the left
}

TEST(WheelReport, IsTheSameWhicheverWayTheWheelFaces) {
  const WheelReport ahead = Motion{2, 0.5, 0.3}.Report();
  const WheelReport turned = Motion{2, 0.5, 0.3, RotationAbout(Vector3d::UnitZ(), 2.2)}.Report();
  EXPECT_NEAR(turned.thrust, ahead.thrust, 1e-6);
  EXPECT_NEAR(turned.lateral_force, ahead.lateral_force, 1e-6);
  EXPECT_NEAR(turned.slip_ratio, ahead.slip_ratio, 1e-9);
  EXPECT_NEAR(turned.slip_angle, ahead.slip_angle, 1e-9);
  EXPECT_NEAR(turned.torque, ahead.torque, 1e-6);
}

// The W axes lie in the ground: on rock a slope changes nothing that a wheel reports.
TEST(WheelReport, IsTheSameOnASlopeAsOnLevelGround) {
  const Eigen::Matrix3d uphill = RotationAbout(Vector3d::UnitY(), -0.3);
  TirePose level = PressedIn(TruckTire(), 0.03);
  level.velocity_w = {2, 0.2, 0};
  level.angular_velocity_w = {0, 5, 0};
  const auto report = [](const TirePose& pose, double slope) {
    const Surface ground(0.05, SurfaceMode::kFlow, Rising(slope));
    PatchForces forces;
    WheelContact(TruckTire(), 0.01).Evaluate(pose, ground, Rock(), 0.01, &forces);
    return ReportOf(TruckTire(), pose, forces);
  };
  const WheelReport flat = report(level, 0);
  const WheelReport steep = report(Rotated(uphill, level), std::tan(0.3));
  ASSERT_GT(flat.load, 1000);
  EXPECT_NEAR(steep.load / flat.load, 1, 1e-6);
  EXPECT_NEAR(steep.thrust / flat.thrust, 1, 1e-6);
  EXPECT_NEAR(steep.motion_resistance, flat.motion_resistance, 1e-6 * flat.load);
  EXPECT_NEAR(steep.slip_ratio, flat.slip_ratio, 1e-9);
  EXPECT_NEAR(steep.slip_angle, flat.slip_angle, 1e-9);
  EXPECT_NEAR(steep.camber, 0, 1e-9);
}

TEST(WheelReport, IsResistedByAStepAhead) {
  Surface step(0.05, SurfaceMode::kFlow, Level);
  Press(&step, 1, [](double x, double) { return x < 0.1 ? 0.05 : 0.0; });
  PatchForces forces;
  const TirePose pose = PressedIn(TruckTire(), 0.08);
  WheelContact(TruckTire(), 0.02).Evaluate(pose, step, TilledLoam(), 0.01, &forces);
  EXPECT_GT(ReportOf(TruckTire(), pose, forces).motion_resistance, 100);
}

TEST(WheelReport, AddsUp) {
  const Motion motion{2, 0.5, 0.3};
  const Surface level(0.05, SurfaceMode::kFlow, Level);
  PatchForces forces;
  WheelContact(TruckTire(), 0.02).Evaluate(motion.Pose(), level, TilledLoam(), 0.2, &forces);
  const WheelReport report = ReportOf(TruckTire(), motion.Pose(), forces);
  EXPECT_NEAR(report.drawbar_pull, forces.wrench.force_w.x(), 1e-6);
  EXPECT_NEAR(report.load, forces.wrench.force_w.z(), 1e-6);
  EXPECT_NEAR(report.torque, -forces.wrench.torque_w.y(), 1e-6);
  EXPECT_GT(report.peak_pressure, report.mean_pressure);
  EXPECT_GT(report.contact_area, 0.05);
  EXPECT_NEAR(report.mean_pressure * report.contact_area / report.load, 1, 0.1);
}

TEST(WheelReport, TellsSinkageAndRutApart) {
  Surface field(0.05, SurfaceMode::kFlow, Level);
  Press(&field, 1, [](double, double) { return 0.03; });
  PatchForces forces;
  const TirePose pose = PressedIn(TruckTire(), 0.08);
  WheelContact(TruckTire(), 0.02).Evaluate(pose, field, TilledLoam(), 0.01, &forces);
  const WheelReport report = ReportOf(TruckTire(), pose, forces);
  EXPECT_NEAR(report.rut_depth, 0.03, 1e-12);  // of before
  EXPECT_GT(report.sinkage, 0.031);            // and on the way down
}

TEST(WheelReport, IsZeroInTheAir) {
  PatchForces forces;
  const Surface level(0.05, SurfaceMode::kFlow, Level);
  const TirePose pose = PressedIn(TruckTire(), -0.1);
  WheelContact(TruckTire(), 0.02).Evaluate(pose, level, TilledLoam(), 0.01, &forces);
  const WheelReport report = ReportOf(TruckTire(), pose, forces);
  EXPECT_EQ(report.load, 0);
  EXPECT_EQ(report.sinkage, 0);
  EXPECT_EQ(report.mean_pressure, 0);
}

}  // namespace
}  // namespace softsoil
