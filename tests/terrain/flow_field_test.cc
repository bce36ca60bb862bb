// Soil that is pushed, taken back, and slides.
#include "terrain/flow_field.h"

#include <gtest/gtest.h>

#include <cmath>

#include "terrain/constants.h"
#include "tests/terrain/pressed_ground.h"

namespace softsoil {
namespace {

constexpr double kDx = 0.05;     // [m]
constexpr double kRepose = 0.5;  // [-]
constexpr double kWall = 0.3;    // [m]
const SoilSlope kSlope = {kRepose, kWall};

Surface Flat() { return Surface(kDx, SurfaceMode::kFlow, FlatGround); }

void Apply(const FlowField& field, Surface* surface) {
  for (const NodeSoil& soil : field.Moved()) surface->SetMoved(soil);
}

// Sum of thicknesses.
double Loose(const Surface& surface) { return surface.MovedVolume() / (kDx * kDx); }

double SteepestSlope(const Surface& surface) {
  double steepest = 0;
  surface.ForEachNode([&](GridNode n, double height, double) {
    for (int i = -1; i <= 1; ++i) {
      for (int j = -1; j <= 1; ++j) {
        if (i == 0 && j == 0) continue;
        const double drop = height - surface.NodeHeight({n.i + i, n.j + j});
        steepest = std::max(steepest, drop / (kDx * std::hypot(i, j)));
      }
    }
  });
  return steepest;
}

// A column of soil that is poured out at the origin.
Surface Heap(double height, int sweeps) {
  Surface surface = Flat();
  FlowField field(surface, kSlope);
  field.Raise(field.Find({0, 0}), height);
  field.Slide(sweeps);
  Apply(field, &surface);
  return surface;
}

TEST(Heap, ComesToRestAtTheAngleOfRepose) {
  const Surface heap = Heap(4, 20000);
  EXPECT_NEAR(SteepestSlope(heap), kRepose, 0.002);
  EXPECT_NEAR(Loose(heap), 4, 1e-12);
  // A cone of this volume and slope is so high.
  const double volume = 4 * kDx * kDx;
  EXPECT_NEAR(heap.NodeHeight({0, 0}), std::cbrt(3 * volume * kRepose * kRepose / kPi), 0.02);
}

TEST(Heap, HasTheSameSlopeOnAllSides) {
  const Surface heap = Heap(2, 5000);
  for (int i = 0; i < 6; ++i) {
    for (int j = 0; j < 6; ++j) {
      const double height = heap.NodeHeight({i, j});
      EXPECT_NEAR(heap.NodeHeight({-i, j}), height, 1e-9);
      EXPECT_NEAR(heap.NodeHeight({j, i}), height, 1e-9);
    }
  }
}

TEST(Heap, GoesOnSlidingWhereItWasInterrupted) {
  Surface surface = Heap(2, 10);
  EXPECT_GT(SteepestSlope(surface), 1.2 * kRepose);
  std::vector<GridNode> restless = {{0, 0}};
  int ticks = 0;
  while (!restless.empty() && ++ticks < 1000) {
    FlowField field(surface, kSlope);
    for (const GridNode node : restless) field.Disturb(field.Find(node));
    field.Slide(10);
    Apply(field, &surface);
    restless = field.Restless();
  }
  EXPECT_GT(ticks, 3);
  EXPECT_LT(ticks, 1000);
  EXPECT_NEAR(SteepestSlope(surface), kRepose, 0.002);
}

// A pit with steep sides, `depth` deep.
Surface Pit(double depth) {
  Surface surface = Flat();
  for (int i = -3; i <= 3; ++i) {
    for (int j = -3; j <= 3; ++j) surface.DeepenPlastic({{i, j}, depth});
  }
  FlowField field(surface, kSlope);
  for (int i = -3; i <= 3; ++i) {
    for (int j = -3; j <= 3; ++j) field.Disturb(field.Find({i, j}));
  }
  field.Slide(20000);
  Apply(field, &surface);
  return surface;
}

TEST(FirmSoil, StandsAsAWallUpToTheCriticalHeight) {
  EXPECT_EQ(Pit(0.9 * kWall).NodeHeight({0, 0}), -0.9 * kWall);
  const Surface fallen = Pit(2 * kWall);
  EXPECT_GT(fallen.NodeHeight({3, 0}), -2 * kWall + 0.01);
  EXPECT_LT(fallen.NodeHeight({4, 0}), -0.01);
  EXPECT_NEAR(Loose(fallen), 0, 1e-12);
}

TEST(LooseSoil, SlidesOffTheRimIntoThePit) {
  Surface pit = Pit(0.2);
  FlowField field(pit, kSlope);
  field.Raise(field.Find({4, 0}), 0.1);
  field.Slide(5000);
  Apply(field, &pit);
  EXPECT_LT(pit.NodeHeight({4, 0}), 0.02);
  EXPECT_GE(pit.NodeHeight({4, 0}), -1e-12);
  EXPECT_GT(pit.NodeHeight({3, 0}), -0.2);
  EXPECT_NEAR(Loose(pit), 0.1, 1e-12);
}

// Two soils that meet at x = 0: up to there heaps stand at 0.5, beyond it at 1.
SoilMap TwoSoils() {
  Soil soil = LooseSoil();
  soil.angle_of_repose = std::atan(0.5);
  Soil steeper = soil;
  steeper.angle_of_repose = std::atan(1.0);
  const Eigen::Vector2d half(5, 5);
  return SoilMap(soil, {{steeper, {5 + kDx / 2, 0}, half.asDiagonal()}});
}

TEST(Heap, StandsOnEachSoilAtItsOwnAngleOfRepose) {
  Surface surface = Flat();
  FlowField field(surface, SoilSlopes(TwoSoils(), kDx));
  field.Raise(field.Find({0, 0}), 0.5);
  field.Raise(field.Find({1, 0}), 0.5);
  field.Slide(5000);
  Apply(field, &surface);
  EXPECT_NEAR(Loose(surface), 1, 1e-12);
  const auto slope = [&](int i, int way) {
    return (surface.NodeHeight({i, 0}) - surface.NodeHeight({i + way, 0})) / kDx;
  };
  EXPECT_NEAR(slope(-1, -1), 0.5, 0.002);
  EXPECT_NEAR(slope(1, 1), 1, 0.002);
}

// A field in which a square of 7 by 7 nodes around the origin is below a tire.
class Footprint : public testing::Test {
 protected:
  Footprint() {
    for (int i = -3; i <= 3; ++i) {
      for (int j = -3; j <= 3; ++j) field_.Cover(field_.Find({i, j}));
    }
  }
  double At(GridNode node) {
    Apply(field_, &surface_);
    return surface_.Layers(node).moved;
  }
  Surface surface_ = Flat();
  FlowField field_{surface_, kSlope};
};

TEST_F(Footprint, IsLeftByTheNearestNodeInTheDirection) {
  field_.PushAway(field_.Find({1, 1}), {2, 0}, 0.01);
  EXPECT_EQ(At({4, 1}), 0.01);
  field_.PushAway(field_.Find({1, -1}), {-1, -1}, 0.01);
  EXPECT_EQ(At({-1, -3}) + At({-2, -4}), 0.01);
}

TEST_F(Footprint, IsLeftOnAllSidesWithoutADirection) {
  field_.PushAway(field_.Find({0, 0}), {0, 0}, 0.08);
  for (const GridNode node : {GridNode{4, 0}, {-4, 4}, {0, -4}, {4, 4}}) {
    EXPECT_NEAR(At(node), 0.01, 1e-15);
  }
}

TEST_F(Footprint, KeepsItsSoilWhileTheTireIsThere) {
  field_.Raise(field_.Find({4, 0}), 0.4);
  field_.Slide(5000);
  EXPECT_EQ(At({3, 0}), 0);
  EXPECT_NEAR(Loose(surface_), 0.4, 1e-12);
}

TEST_F(Footprint, TakesSoilBackFromTheNearestBerms) {
  field_.Raise(field_.Find({0, 5}), 0.02);
  field_.Raise(field_.Find({0, -5}), 0.02);
  field_.Raise(field_.Find({0, 7}), 0.02);
  field_.TakeFromAround({{field_.Find({0, 0}), 0.03}}, 10);
  EXPECT_NEAR(At({0, 5}), 0.005, 1e-15);
  EXPECT_NEAR(At({0, -5}), 0.005, 1e-15);
  EXPECT_NEAR(At({0, 7}), 0.02, 1e-15);
}

TEST_F(Footprint, SharesWhatTwoAskFor) {
  field_.Raise(field_.Find({0, 5}), 0.02);
  field_.TakeFromAround({{field_.Find({0, 3}), 0.01}, {field_.Find({0, 7}), 0.03}}, 10);
  EXPECT_NEAR(At({0, 5}), 0, 1e-15);
  EXPECT_NEAR(At({0, 3}), -0.005, 1e-15);
  EXPECT_NEAR(At({0, 7}), -0.015, 1e-15);
}

TEST_F(Footprint, SinksWhereThereIsNoSoilToTakeBack) {
  field_.Raise(field_.Find({0, 5}), 0.02);
  field_.TakeFromAround({{field_.Find({0, 0}), 0.03}}, 10);
  EXPECT_NEAR(At({0, 5}), 0, 1e-15);
  EXPECT_NEAR(At({0, 0}), -0.01, 1e-15);
}

}  // namespace
}  // namespace softsoil
