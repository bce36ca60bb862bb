// What makes the surface sink, and by how much it has sunk.
#include <gtest/gtest.h>

#include <vector>

#include "terrain/surface.h"

namespace softsoil {
namespace {

constexpr double kDx = 0.1;  // [m]

Surface Flat(SurfaceMode mode) {
  return Surface(kDx, mode, [](double, double) { return 0.0; });
}

TEST(Rut, OfBearingNeverRises) {
  Surface surface = Flat(SurfaceMode::kFlow);
  for (double sinkage : {0.02, 0.05, 0.03, 0.0, -0.1}) surface.DeepenPlastic({{3, 4}, sinkage});
  EXPECT_EQ(surface.NodeHeight({3, 4}), -0.05);
}

TEST(Rut, OfFlowIsTheLargerOfCompactionAndBearing) {
  Surface surface = Flat(SurfaceMode::kFlow);
  surface.DeepenPlastic({{0, 0}, 0.05});
  surface.SetCompaction({{0, 0}, 0.02});
  surface.DeepenPlastic({{1, 0}, 0.01});
  surface.SetCompaction({{1, 0}, 0.02});
  EXPECT_EQ(surface.NodeHeight({0, 0}), -0.05);
  EXPECT_EQ(surface.NodeHeight({1, 0}), -0.02);
}

TEST(Rut, OfCompactionIgnoresBearing) {
  Surface surface = Flat(SurfaceMode::kCompaction);
  surface.DeepenPlastic({{0, 0}, 0.05});
  EXPECT_EQ(surface.NodeHeight({0, 0}), 0);
  EXPECT_EQ(surface.MemoryBytes(), 0u);
  surface.SetCompaction({{0, 0}, 0.02});
  surface.DeepenPlastic({{0, 0}, 0.05});
  EXPECT_EQ(surface.NodeHeight({0, 0}), -0.02);
  EXPECT_EQ(surface.DisplacedVolume(), 0);
}

TEST(Rut, OfCompactionRisesWithRebound) {
  Surface surface = Flat(SurfaceMode::kCompaction);
  surface.SetCompaction({{0, 0}, 0.02});
  surface.SetCompaction({{0, 0}, 0.015});
  EXPECT_EQ(surface.NodeHeight({0, 0}), -0.015);
}

TEST(Rut, FollowsTheGroundItIsIn) {
  Surface surface(kDx, SurfaceMode::kFlow, [](double x, double y) { return 2 * x + y; });
  surface.DeepenPlastic({{-2, 5}, 0.04});
  EXPECT_NEAR(surface.NodeHeight({-2, 5}), -0.4 + 0.5 - 0.04, 1e-12);
  EXPECT_NEAR(surface.Undisturbed({-2, 5}), -0.4 + 0.5, 1e-12);
  EXPECT_NEAR(surface.NodeHeight({-2, 6}), -0.4 + 0.6, 1e-12);
}

// A trench of 40 by 3 nodes, 5 cm deep, of which 2 cm are compaction.
TEST(Rut, OfKnownShapeHasItsVolume) {
  Surface surface = Flat(SurfaceMode::kFlow);
  for (int i = -20; i < 20; ++i) {
    for (int j = -1; j <= 1; ++j) {
      surface.DeepenPlastic({{i, j}, 0.05});
      surface.SetCompaction({{i, j}, 0.02});
    }
  }
  EXPECT_NEAR(surface.RutVolume(), 120 * kDx * kDx * 0.05, 1e-12);
  EXPECT_NEAR(surface.DisplacedVolume(), 120 * kDx * kDx * 0.03, 1e-12);
}

// The volume on the grid is the volume below the bilinear surface.
TEST(Rut, HasTheVolumeBelowTheBilinearSurface) {
  Surface surface = Flat(SurfaceMode::kFlow);
  surface.DeepenPlastic({{0, 0}, 0.05});
  surface.DeepenPlastic({{1, 2}, 0.03});
  double volume = 0;
  const double d = 0.005;
  for (double x = -0.2 + d / 2; x < 0.4; x += d) {
    for (double y = -0.2 + d / 2; y < 0.4; y += d) volume -= surface.Height(x, y) * d * d;
  }
  EXPECT_NEAR(surface.RutVolume(), volume, 1e-6 * volume);
}

TEST(Rut, TakesMemoryOnlyForTouchedTiles) {
  Surface surface = Flat(SurfaceMode::kFlow);
  EXPECT_EQ(surface.MemoryBytes(), 0u);
  EXPECT_EQ(surface.Height(1000, -1000), 0);
  EXPECT_EQ(surface.MemoryBytes(), 0u);
  surface.DeepenPlastic({{0, 0}, 0.01});
  const std::size_t one = surface.MemoryBytes();
  EXPECT_GT(one, 0u);
  surface.DeepenPlastic({{15, 15}, 0.01});
  EXPECT_EQ(surface.MemoryBytes(), one);
  surface.DeepenPlastic({{16, 15}, 0.01});
  EXPECT_EQ(surface.MemoryBytes(), 2 * one);
}

struct Visited {
  int i, j;
  double height, sinkage;
};

std::vector<Visited> Visits(const Surface& surface) {
  std::vector<Visited> visits;
  surface.ForEachNode([&](GridNode node, double height, double sinkage) {
    visits.push_back({node.i, node.j, height, sinkage});
  });
  return visits;
}

TEST(Rut, IsVisitedInTheSameOrderHoweverItCameAbout) {
  Surface there = Flat(SurfaceMode::kFlow), back = Flat(SurfaceMode::kFlow);
  for (int i = -40; i <= 40; ++i) {
    there.DeepenPlastic({{i, i / 2}, 0.01 + 0.001 * i * i});
    back.DeepenPlastic({{-i, -i / 2}, 0.01 + 0.001 * i * i});
  }
  const std::vector<Visited> a = Visits(there), b = Visits(back);
  ASSERT_GT(a.size(), 6 * 256u);
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t k = 0; k < a.size(); ++k) {
    ASSERT_EQ(a[k].i, b[k].i);
    ASSERT_EQ(a[k].j, b[k].j);
    ASSERT_EQ(a[k].height, b[k].height);
    ASSERT_EQ(a[k].height, -a[k].sinkage);
  }
  EXPECT_EQ(there.RutVolume(), back.RutVolume());
}

}  // namespace
}  // namespace softsoil
