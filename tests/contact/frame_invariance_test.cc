// Where a wheel is and which way it faces does not matter.
#include <gtest/gtest.h>

#include "terrain/point_load.h"
#include "tests/contact/ground_samples.h"
#include "tests/contact/samples.h"

namespace softsoil {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kGrid = 0.05;  // [m]

// Driven, sliding, cambered and pressed in 8 cm.
TirePose AnyPose(const Tire& tire) {
  TirePose pose = PressedIn(tire, 0.08);
  pose.frame_w = RotationAbout(Vector3d::UnitX(), 0.1) * RotationAbout(Vector3d::UnitY(), 0.37);
  pose.velocity_w = Vector3d(1, 0.2, -0.1);
  pose.angular_velocity_w = 1.5 * pose.frame_w.col(1);
  return pose;
}

Wrench WrenchOn(const Surface& surface, const TirePose& pose, double node_spacing = kGrid) {
  PatchForces forces;
  WheelContact(AgriculturalTire(), node_spacing)
      .Evaluate(pose, surface, TilledLoam(), 0.005, &forces);
  return forces.wrench;
}

void ExpectRotated(const Wrench& turned, const Matrix3d& rotation, const Wrench& plain,
                   double tolerance) {
  EXPECT_LT(RelativeError(turned.force_w, rotation * plain.force_w), tolerance);
  EXPECT_LT(RelativeError(turned.torque_w, rotation * plain.torque_w), tolerance);
}

TEST(FrameInvariance, HoldsForQuarterTurnsOfARuttedField) {
  const TirePose pose = AnyPose(AgriculturalTire());
  Surface field(kGrid, SurfaceMode::kFlow, Level);
  Press(&field, 1, Waves);
  const Wrench plain = WrenchOn(field, pose);
  ASSERT_GT(plain.force_w.head<2>().norm(), 500);
  for (int quarter = 1; quarter < 4; ++quarter) {
    const Matrix3d turn = RotationAbout(Vector3d::UnitZ(), quarter * kPi / 2);
    Surface turned(kGrid, SurfaceMode::kFlow, Level);
    Press(&turned, 1, [&](double x, double y) {
      const Vector3d before = turn.transpose() * Vector3d(x, y, 0);
      return Waves(before.x(), before.y());
    });
    ExpectRotated(WrenchOn(turned, Rotated(turn, pose)), turn, plain, 1e-9);
  }
}

TEST(FrameInvariance, HoldsForShiftsByWholeCellsOfARuttedField) {
  TirePose pose = AnyPose(AgriculturalTire());
  Surface field(kGrid, SurfaceMode::kFlow, Level);
  Press(&field, 1, Waves);
  const Wrench plain = WrenchOn(field, pose);
  for (const Vector3d& shift : {Vector3d(5, 0, 0), Vector3d(-12.5, 3.15, 0)}) {
    Surface shifted(kGrid, SurfaceMode::kFlow, Level);
    Press(&shifted, 20, [&](double x, double y) {
      const bool inside =
          std::max(std::abs(x - shift.x()), std::abs(y - shift.y())) < 1 + kGrid / 2;
      return inside ? Waves(x - shift.x(), y - shift.y()) : 0.0;
    });
    TirePose moved = pose;
    moved.centre_w += shift;
    ExpectRotated(WrenchOn(shifted, moved), Matrix3d::Identity(), plain, 1e-9);
  }
}

TEST(FrameInvariance, HoldsForAnyTurnAndShiftOfUndisturbedGround) {
  const Surface level(kGrid, SurfaceMode::kFlow, Level);
  const TirePose pose = AnyPose(AgriculturalTire());
  const Wrench plain = WrenchOn(level, pose);
  for (double angle = 0.1; angle < 6.2; angle += 0.7) {
    const Matrix3d turn = RotationAbout(Vector3d::UnitZ(), angle);
    TirePose turned = Rotated(turn, pose);
    turned.centre_w += Vector3d(100 * angle, -37.123, 0);
    ExpectRotated(WrenchOn(level, turned), turn, plain, 1e-9);
  }
}

// How far the wheel has spun shows only in the places of its nodes.
TEST(FrameInvariance, HoldsForTheSpinAngleUpToTheNodes) {
  const Surface level(kGrid, SurfaceMode::kFlow, Level);
  const auto spun = [&](double angle, double spacing) {
    TirePose pose = AnyPose(AgriculturalTire());
    pose.frame_w = pose.frame_w * RotationAbout(Vector3d::UnitY(), angle);
    return WrenchOn(level, pose, spacing).force_w;
  };
  for (double angle : {0.01, 0.025, 0.5, 3.0}) {
    EXPECT_LT(RelativeError(spun(angle, 0.05), spun(0, 0.05)), 0.03);
    EXPECT_LT(RelativeError(spun(angle, 0.0125), spun(0, 0.0125)), 0.005);
  }
}

// Left and right are mirror images: camber, steer and sideslip change sign together.
TEST(FrameInvariance, HoldsForTheMirrorImage) {
  const Surface level(kGrid, SurfaceMode::kFlow, Level);
  const Matrix3d mirror = Vector3d(1, -1, 1).asDiagonal();
  for (double camber : {-0.2, 0.05, 0.3}) {
    for (double steer : {-0.4, 0.0, 0.2}) {
      TirePose pose = PressedIn(AgriculturalTire(), 0.08);
      pose.frame_w =
          RotationAbout(Vector3d::UnitZ(), steer) * RotationAbout(Vector3d::UnitX(), camber);
      pose.velocity_w = Vector3d(1, 0.2, -0.1);
      pose.angular_velocity_w = 1.5 * pose.frame_w.col(1);
      TirePose image = pose;
      image.frame_w = mirror * pose.frame_w * mirror;
      image.velocity_w = mirror * pose.velocity_w;
      image.angular_velocity_w = -(mirror * pose.angular_velocity_w);  // an axial vector
      const Wrench plain = WrenchOn(level, pose), mirrored = WrenchOn(level, image);
      EXPECT_LT(RelativeError(mirrored.force_w, mirror * plain.force_w), 1e-9);
      EXPECT_LT(RelativeError(mirrored.torque_w, -(mirror * plain.torque_w)), 1e-9);
    }
  }
}

// The law measures depth along the vertical, so on a slope soil bears a few per cent differently
// along its normal; rock bears the same.
TEST(FrameInvariance, HoldsForAnInclinedPlane) {
  for (double angle : {0.1, 0.1745, 0.3}) {
    const Matrix3d tilt = RotationAbout(Vector3d::UnitY(), -angle);  // x goes up
    const Surface level(kGrid, SurfaceMode::kFlow, Level);
    const Surface slope(kGrid, SurfaceMode::kFlow, Rising(std::tan(angle)));
    for (const Soil& soil : {TilledLoam(), Rock()}) {
      const TirePose pose = AnyPose(AgriculturalTire());
      PatchForces plain, tilted;
      const WheelContact wheel(AgriculturalTire(), 0.02);
      wheel.Evaluate(pose, level, soil, 0.005, &plain);
      wheel.Evaluate(Rotated(tilt, pose), slope, soil, 0.005, &tilted);
      const double tolerance = soil.bearing.k_phi > 1e12 ? 1e-6 : 1 / std::cos(angle) - 1 + 0.005;
      EXPECT_LT(RelativeError(tilted.wrench.force_w, tilt * plain.wrench.force_w), tolerance)
          << soil.name << " " << angle;
    }
  }
}

}  // namespace
}  // namespace softsoil
