// Where displaced soil goes, on a ground that a plate presses on.
#include "terrain/soil_flow.h"

#include <gtest/gtest.h>

#include <cmath>

#include "terrain/ground.h"
#include "tests/terrain/pressed_ground.h"
#include "tests/terrain/written_bytes.h"

namespace softsoil {
namespace {

constexpr double kDx = 0.05;     // [m]
constexpr double kDepth = 0.06;  // [m]

GroundSettings Settings(int threads = 1, bool sync = true) {
  GroundSettings settings = CoarseGround(12, sync);
  settings.threads = threads;
  return settings;
}

// A round plate of 15 cm around a node, pressed in to kDepth for 1 ms; it drags the ground along x
// with a share of its load.
void Press(Ground& ground, GridNode centre, double drag = 0, double pressure = 250e3) {
  const Circle plate{centre, 0.15, pressure};
  std::vector<SurfaceForce> forces = ForcesOf(plate, kDx);
  for (SurfaceForce& force : forces) force.force_w.x() = -drag * force.force_w.z();
  std::vector<NodeSinkage> depths;
  ForEachNodeIn(plate, kDx, [&](GridNode node) { depths.push_back({node, kDepth}); });
  ground.Reserve(0, forces, depths);
  ground.AddLoad(0, forces, 0.001);
  ground.DeepenPlastic(0, depths);
  ground.Pass(0.001);
}

// Share of the displaced volume that is neither on the ground nor in hand.
double LostShare(const Ground& ground) {
  const Surface& surface = ground.surface();
  const double there = surface.MovedVolume() + ground.VolumeInHand();
  return std::abs(surface.DisplacedVolume() - there) / surface.DisplacedVolume();
}

// A plate that moves along x by a node every 20 ms.
Ground Track(int steps, const GroundSettings& settings, double drag = 0, double pressure = 250e3) {
  Ground ground(LooseSoil(), settings, FlatGround, 1);
  double most_lost = 0;
  for (int step = 0; step < steps; ++step) {
    Press(ground, {step / 20, 0}, drag, pressure);
    most_lost = std::max(most_lost, LostShare(ground));
  }
  EXPECT_LT(most_lost, 1e-9);
  return ground;
}

TEST(Flow, KeepsItsVolumeOverAThousandStepsOnAnyThreads) {
  for (const bool sync : {true, false}) {
    const Ground one = Track(1000, Settings(1, sync)), two = Track(1000, Settings(2, sync));
    EXPECT_GT(one.surface().CompactionVolume(), 0.05 * one.surface().DisplacedVolume());
    EXPECT_GT(one.surface().BermVolume(), 0.1 * one.surface().DisplacedVolume());
    EXPECT_EQ(BytesOf(one), BytesOf(two));
  }
}

TEST(Flow, FillsBermsWithWhatTheRutHasLostWhereNothingCompacts) {
  const Ground ground = Track(200, Settings(), 0, 100);
  const Surface& surface = ground.surface();
  EXPECT_EQ(surface.CompactionVolume(), 0);
  EXPECT_GT(surface.BermVolume(), 0.5 * surface.DisplacedVolume());
  EXPECT_NEAR(surface.BermVolume() + ground.VolumeInHand(), surface.RutVolume(), 1e-12);
}

TEST(Flow, RaisesBermsAlikeOnBothSides) {
  const Ground ground = Track(400, Settings());
  double highest = 0;
  for (int i = -8; i < 28; ++i) {
    for (int j = 1; j < 20; ++j) {
      const double left = ground.surface().NodeHeight({i, j});
      EXPECT_NEAR(ground.surface().NodeHeight({i, -j}), left, 1e-4) << i << ", " << j;
      highest = std::max(highest, left);
    }
  }
  EXPECT_GT(highest, 0.005);
}

// Centre along x [m] of the soil above the undisturbed ground.
double CentreOfBerms(const Ground& ground) {
  double sum = 0, moment = 0;
  ground.surface().ForEachNode([&](GridNode node, double height, double) {
    sum += std::max(height, 0.0);
    moment += std::max(height, 0.0) * node.i * kDx;
  });
  return moment / sum;
}

TEST(Flow, GoesTheWayInWhichThePlateDragsTheGround) {
  EXPECT_NEAR(CentreOfBerms(Track(20, Settings())), 0, 1e-4);
  EXPECT_GT(CentreOfBerms(Track(20, Settings(), 0.5)), 0.02);
  EXPECT_LT(CentreOfBerms(Track(20, Settings(), -0.5)), -0.02);
}

// Forward as under a wheel that slides, and back as under one that spins.
TEST(Flow, PilesUpAheadOfWhatSlides) {
  const auto ahead = [](const Ground& ground) {
    double volume = 0;
    for (int i = 43; i < 60; ++i) {
      for (int j = -10; j <= 10; ++j) {
        volume += std::max(ground.surface().NodeHeight({i, j}), 0.0);
      }
    }
    return volume;
  };
  EXPECT_GT(ahead(Track(800, Settings(), 0.7)), 1.1 * ahead(Track(800, Settings(), -0.7)));
}

TEST(Flow, IsTakenBackAsCompactionCatchesUp) {
  Ground ground(LooseSoil(), Settings(), FlatGround, 1);
  for (int step = 0; step < 20; ++step) Press(ground, {0, 0});
  const double early = ground.surface().BermVolume();
  for (int step = 0; step < 600; ++step) Press(ground, {0, 0});
  EXPECT_LT(ground.surface().BermVolume(), 0.9 * early);
  EXPECT_LT(LostShare(ground), 1e-9);
}

TEST(Flow, ComesToRestOnceThePlateHasGone) {
  Ground ground = Track(100, Settings(), 0, 100);
  for (int tick = 0; tick < 600; ++tick) ground.Pass(0.01);
  const auto settled = BytesOf(ground);
  for (int tick = 0; tick < 5; ++tick) ground.Pass(0.01);
  EXPECT_EQ(BytesOf(ground), settled);
}

// Loose soil bears nothing: who comes after pushes it away first, then meets the ground below.
TEST(Flow, IsPushedAwayByWhoComesNext) {
  Ground ground = Track(100, Settings());
  const GridNode berm{2, 4};
  const double height = ground.surface().NodeHeight(berm);
  ASSERT_GT(height, 0.005);
  const double displaced = ground.surface().DisplacedVolume();
  ground.DeepenPlastic(0, {{berm, 0}});
  EXPECT_NEAR(ground.surface().NodeHeight(berm), 0, 1e-15);
  EXPECT_EQ(ground.surface().DisplacedVolume(), displaced);
  EXPECT_LT(LostShare(ground), 1e-9);
}

TEST(Flow, IsNoneInTheModeCompaction) {
  GroundSettings settings = Settings();
  settings.mode = SurfaceMode::kCompaction;
  Ground ground(LooseSoil(), settings, FlatGround, 1);
  for (int step = 0; step < 100; ++step) Press(ground, {0, 0}, 0.5);
  EXPECT_GT(ground.surface().CompactionVolume(), 0);
  EXPECT_EQ(ground.surface().MovedVolume(), 0);
  EXPECT_EQ(ground.surface().BermVolume(), 0);
  EXPECT_EQ(ground.VolumeInHand(), 0);
}

TEST(Flow, ReservesWithoutATrace) {
  Ground ground(LooseSoil(), Settings(), FlatGround, 1);
  Press(ground, {0, 0});
  const auto before = BytesOf(ground);
  ground.Reserve(0, {}, {{{0, 0}, 0.1}, {{1, 0}, 0.1}});
  EXPECT_EQ(BytesOf(ground), before);
}

}  // namespace
}  // namespace softsoil
