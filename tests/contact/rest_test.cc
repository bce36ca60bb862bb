// A wheel that nobody turns stays where it is.
#include <gtest/gtest.h>

#include <cmath>

#include "contact/soft_wheels.h"
#include "terrain/point_load.h"
#include "tests/contact/samples.h"

namespace softsoil {
namespace {

using Eigen::Vector3d;

constexpr double kStep = 0.001;        // [s]
constexpr double kMass = 6100 / 9.81;  // [kg]  a quarter of the HMMWV
const Vector3d kGravity(0, 0, -9.81);  // [m/s^2]
const Vector3d kByHand(20, 20, 20);    // [1/s]
const Vector3d kSuspension(0, 0, 5);   // [1/s]

// A wheel with its brake locked, free to move in space but not to turn. It faces along x, or with
// `heading` [rad] to the left of it, on ground that rises along x.
class LockedWheel {
 public:
  LockedWheel(double slope_angle, double heading, SurfaceMode mode)
      : wheels_(TilledLoam(), Settings(mode), Rising(std::tan(slope_angle)), {TruckTire()}) {
    const double r = TruckTire().shape.radius;
    pose_ = PoseAt(-r * std::sin(slope_angle), 0, r * std::cos(slope_angle));
    pose_.frame_w =
        RotationAbout(Vector3d::UnitY(), -slope_angle) * RotationAbout(Vector3d::UnitZ(), heading);
  }
  // `damped` [1/s]: by hands that lower the wheel, or by a suspension.
  void Run(double seconds, const Vector3d& damped = Vector3d::Zero()) {
    for (int k = 0; k < std::lround(seconds / kStep); ++k) Step(damped);
  }
  const Vector3d& place() const { return pose_.centre_w; }
  const Vector3d& velocity() const { return pose_.velocity_w; }

 private:
  static GroundSettings Settings(SurfaceMode mode) {
    GroundSettings settings;
    settings.grid_spacing = 0.05;
    settings.volume_height = 0.1;
    settings.volumes = 8;
    settings.sync = true;
    settings.mode = mode;
    return settings;
  }
  void Step(const Vector3d& damped) {
    wheels_.Evaluate(0, pose_, kStep, &forces_[0]);
    const Vector3d acceleration =
        forces_[0].wrench.force_w / kMass + kGravity - damped.cwiseProduct(pose_.velocity_w);
    wheels_.Commit({pose_}, forces_, kStep);
    pose_.velocity_w += kStep * acceleration;
    pose_.centre_w += kStep * pose_.velocity_w;
  }

  SoftWheels wheels_;
  TirePose pose_;
  std::vector<PatchForces> forces_ = std::vector<PatchForces>(1);
};

struct Way {
  double heading;  // [rad]
  SurfaceMode mode;
};
class Rest : public testing::TestWithParam<Way> {};

TEST_P(Rest, LastsOnASlopeOfTenDegrees) {
  LockedWheel wheel(10 * kPi / 180, GetParam().heading, GetParam().mode);
  wheel.Run(2, kByHand);
  const Vector3d settled = wheel.place();
  double fastest = 0;
  for (int tenth = 0; tenth < 100; ++tenth) {
    wheel.Run(0.1);
    fastest = std::max(fastest, wheel.velocity().norm());
  }
  EXPECT_LT((wheel.place() - settled).norm(), 1e-3);
  EXPECT_LT(fastest, 1e-3);
}

// Dropped from touch it swings on its shear first. It must neither swing on nor creep down.
TEST_P(Rest, ComesBackAfterADropOntoTheSlope) {
  LockedWheel wheel(10 * kPi / 180, GetParam().heading, GetParam().mode);
  wheel.Run(12, kSuspension);
  const Vector3d settled = wheel.place();
  wheel.Run(10, kSuspension);
  EXPECT_LT((wheel.place() - settled).norm(), 1e-4);
  EXPECT_LT(wheel.velocity().norm(), 1e-4);
}

TEST_P(Rest, HasNoDirectionOnLevelGround) {
  LockedWheel wheel(0, GetParam().heading, GetParam().mode);
  wheel.Run(2, kByHand);
  EXPECT_LT(wheel.place().head<2>().norm(), 1e-9);
  EXPECT_LT(wheel.velocity().norm(), 1e-4);
  EXPECT_LT(wheel.place().z(), TruckTire().shape.radius - 0.03);
}

// Neither rubber (0.65, 33 degrees) nor soil (c 7 kPa, phi 21 degrees) holds a wheel there.
TEST_P(Rest, EndsOnASlopeSteeperThanFrictionAllows) {
  LockedWheel wheel(40 * kPi / 180, GetParam().heading, SurfaceMode::kCompaction);
  wheel.Run(1);
  const Vector3d after_a_second = wheel.place();
  wheel.Run(1);
  EXPECT_LT(wheel.place().x(), after_a_second.x() - 0.5);
  EXPECT_LT(wheel.velocity().x(), -0.5);
}

INSTANTIATE_TEST_SUITE_P(
    Headings, Rest,
    testing::Values(Way{0, SurfaceMode::kFlow}, Way{kPi / 2, SurfaceMode::kFlow},
                    Way{0, SurfaceMode::kCompaction}, Way{kPi / 2, SurfaceMode::kCompaction}),
    [](const testing::TestParamInfo<Way>& info) {
      return std::string(info.param.heading == 0 ? "FacingUphill" : "AcrossTheSlope") +
             (info.param.mode == SurfaceMode::kFlow ? "Flow" : "Compaction");
    });

}  // namespace
}  // namespace softsoil
