// The ground gives no work away: over a closed path of the wheel it takes some or returns all.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "contact/soft_wheels.h"
#include "terrain/point_load.h"
#include "tests/contact/samples.h"

namespace softsoil {
namespace {

using Eigen::Vector3d;

// Where the wheel is [m] and how far it has spun [rad].
struct Place {
  Vector3d centre_w;
  double spun;
};

GroundSettings Settings(SurfaceMode mode, double h) {
  GroundSettings settings;
  settings.grid_spacing = 0.05;
  settings.volume_height = 0.1;
  settings.volumes = 8;
  settings.soil_clock = 10 * h;
  settings.sync = true;
  settings.mode = mode;
  return settings;
}

struct Balance {
  double gained = 0;  // [J]  by the wheel over the whole path
  double most = 0;    // [J]  that the ground had taken at most
};

Balance Walk(const Tire& tire, const Soil& soil, SurfaceMode mode, const std::vector<Place>& path,
             double h) {
  SoftWheels wheels(soil, Settings(mode, h), Level, {tire});
  Balance balance;
  std::vector<PatchForces> forces(1);
  for (std::size_t k = 0; k + 1 < path.size(); ++k) {
    const Vector3d step = path[k + 1].centre_w - path[k].centre_w;
    const double turn = path[k + 1].spun - path[k].spun;
    TirePose pose;  // half way: the work of a step is then that of the way back
    pose.centre_w = (path[k].centre_w + path[k + 1].centre_w) / 2;
    pose.frame_w = RotationAbout(Vector3d::UnitY(), (path[k].spun + path[k + 1].spun) / 2);
    pose.velocity_w = step / h;
    pose.angular_velocity_w = Vector3d(0, turn / h, 0);
    wheels.Evaluate(0, pose, h, &forces[0]);
    balance.gained += forces[0].wrench.force_w.dot(step) + forces[0].wrench.torque_w.y() * turn;
    balance.most = std::max(balance.most, -balance.gained);
    wheels.Commit({pose}, forces, h);
  }
  return balance;
}

// From 1 cm above the ground; `excursion` [m], `turn` [rad] while pressed in; the same way back.
std::vector<Place> ThereAndBack(const Tire& tire, double depth, const Vector3d& excursion,
                                double turn) {
  std::vector<Place> path;
  constexpr int kSteps = 100;
  const double r = tire.shape.radius;
  for (int k = 0; k <= kSteps; ++k) {
    path.push_back({{0, 0, r + 0.01 - (depth + 0.01) * k / kSteps}, 0});
  }
  for (int k = 1; k <= kSteps; ++k) {
    const double share = static_cast<double>(k) / kSteps;
    path.push_back({path[kSteps].centre_w + share * excursion, share * turn});
  }
  for (std::size_t k = path.size() - 1; k-- > 0;) path.push_back(path[k]);
  return path;
}

constexpr double kNothing = 1e-9;  // [J]

TEST(Energy, IsNotGainedByPushAndRelease) {
  const Tire tire = AgriculturalTire();
  for (SurfaceMode mode : {SurfaceMode::kCompaction, SurfaceMode::kFlow}) {
    for (double h : {1e-5, 1e-3, 0.1}) {  // 26 m/s to 2.6 mm/s
      for (double depth : {0.02, 0.12}) {
        const auto path = ThereAndBack(tire, depth, Vector3d::Zero(), 0);
        const Balance balance = Walk(tire, TilledLoam(), mode, path, h);
        EXPECT_LE(balance.gained, kNothing) << h << " " << depth;
        EXPECT_GT(balance.most, 1) << h << " " << depth;
      }
    }
  }
}

TEST(Energy, IsNotGainedBySlippingForthAndBack) {
  const Tire tire = AgriculturalTire();
  const Vector3d excursions[] = {{0.3, 0, 0},   {0, 0.3, 0},     {-0.2, 0.2, 0}, {0.005, 0, 0},
                                 {0, 0.004, 0}, {0.3, 0, -0.03}, {0.3, 0, 0.03}};
  for (SurfaceMode mode : {SurfaceMode::kCompaction, SurfaceMode::kFlow}) {
    for (const Vector3d& excursion : excursions) {
      for (double h : {1e-4, 1e-2}) {
        const auto path = ThereAndBack(tire, 0.08, excursion, 0);
        const Balance balance = Walk(tire, TilledLoam(), mode, path, h);
        EXPECT_LE(balance.gained, kNothing) << excursion.transpose() << " " << h;
        EXPECT_GT(balance.most, 1);
      }
    }
  }
}

// Locked, braked, free rolling, driven, spinning on the spot, backwards.
TEST(Energy, IsNotGainedByRollingForthAndBack) {
  const Tire tire = AgriculturalTire();
  for (SurfaceMode mode : {SurfaceMode::kCompaction, SurfaceMode::kFlow}) {
    for (double slip : {-1.0, -0.2, 0.0, 0.1, 0.5, 5.0}) {
      for (double way : {0.5, -0.5}) {
        const double turn = way * (1 + slip) / tire.shape.radius;
        const auto path = ThereAndBack(tire, 0.08, {way, 0, 0}, turn);
        EXPECT_LE(Walk(tire, TilledLoam(), mode, path, 1e-3).gained, kNothing) << slip;
      }
    }
  }
}

// Straight from corner to corner without turning, 100 steps each.
std::vector<Place> Through(const std::vector<Vector3d>& corners) {
  std::vector<Place> path = {{corners[0], 0}};
  for (std::size_t leg = 0; leg + 1 < corners.size(); ++leg) {
    for (int k = 1; k <= 100; ++k) {
      path.push_back({corners[leg] + k / 100.0 * (corners[leg + 1] - corners[leg]), 0});
    }
  }
  return path;
}

void ExpectNoGain(const Tire& tire, const std::vector<Place>& path) {
  for (const Soil& soil : {TilledLoam(), Rock()}) {
    for (SurfaceMode mode : {SurfaceMode::kCompaction, SurfaceMode::kFlow}) {
      EXPECT_LE(Walk(tire, soil, mode, path, 1e-3).gained, kNothing) << soil.name;
    }
  }
}

TEST(Energy, IsNotGainedAroundASquare) {
  const double up = TruckTire().shape.radius + 0.01, down = TruckTire().shape.radius - 0.06;
  ExpectNoGain(TruckTire(), Through({{0, 0, up},
                                     {0, 0, down},
                                     {0.2, 0, down},
                                     {0.2, 0.2, down},
                                     {0, 0.2, down},
                                     {0, 0, down},
                                     {0, 0, up}}));
}

// Slip under light pressure, press, let the shear push back, lift: not a machine either.
TEST(Energy, IsNotGainedByPressingBetweenSlipAndReturn) {
  const double r = TruckTire().shape.radius, up = r + 0.01, light = r - 0.01, deep = r - 0.06;
  const double slipped = 0.05, back = slipped - 0.7 * TilledLoam().shear.modulus;
  ExpectNoGain(Undamped(TruckTire()), Through({{0, 0, up},
                                               {0, 0, light},
                                               {slipped, 0, light},
                                               {slipped, 0, deep},
                                               {back, 0, deep},
                                               {back, 0, up},
                                               {0, 0, up}}));
}

// A tire on rock is a spring: slow push and release return everything, but for the little that
// the nodes rub across.
TEST(Energy, ComesBackFromATireOnRock) {
  Tire tire = Undamped(TruckTire());
  tire.soil_friction = 1e-9;
  const auto path = ThereAndBack(tire, 0.05, Vector3d::Zero(), 0);
  const Balance balance = Walk(tire, Rock(), SurfaceMode::kFlow, path, 1e-3);
  EXPECT_GT(balance.most, 100);
  EXPECT_NEAR(balance.gained, 0, 1e-6 * balance.most);
}

// In flow the work of sinkage stays in the ground; in compaction it springs back.
TEST(Energy, StaysInTheRut) {
  const Tire tire = Undamped(AgriculturalTire());
  const auto path = ThereAndBack(tire, 0.08, Vector3d::Zero(), 0);
  const Balance flow = Walk(tire, TilledLoam(), SurfaceMode::kFlow, path, 1e-3);
  EXPECT_LT(flow.gained, -0.25 * flow.most);
  const Balance compaction = Walk(tire, TilledLoam(), SurfaceMode::kCompaction, path, 1e-3);
  EXPECT_GT(compaction.gained, -0.2 * compaction.most);
}

}  // namespace
}  // namespace softsoil
