// A surface asked what it will be is what it says.
#include "terrain/compacted_surface.h"

#include <gtest/gtest.h>

#include <vector>

namespace softsoil {
namespace {

constexpr double kDx = 0.5;  // [m]

// Pressed, compacted and heaped up at some nodes; those of i = 20 lie in a tile that nobody
// touched.
Surface Driven() {
  Surface surface(kDx, SurfaceMode::kFlow, [](double x, double y) { return 0.1 * x - 0.2 * y; });
  surface.DeepenPlastic({{-1, 3}, 0.05});
  surface.DeepenPlastic({{1, 2}, 0.04});
  surface.SetCompaction({{1, 2}, 0.03});
  surface.SetCompaction({{1, 3}, 0.03});
  surface.SetMoved({{1, 2}, 0.02});
  surface.SetMoved({{2, 2}, -0.01});
  return surface;
}

// In the order of a soil update: catches up, overtakes, rebounds, begins.
const std::vector<NodeSinkage> kCompaction = {
    {{-1, 3}, 0.02}, {{1, 2}, 0.06}, {{1, 3}, 0.01}, {{2, 2}, 0.03}, {{20, 3}, 0.02}};

constexpr int kNodes[] = {-2, -1, 0, 1, 2, 3, 20};

TEST(CompactedSurface, IsWhatTheSurfaceComesToBe) {
  Surface surface = Driven();
  const Surface before = surface;
  const CompactedSurface asked(before, kCompaction);
  for (const NodeSinkage& c : kCompaction) surface.SetCompaction(c);
  int differ = 0;
  for (const int i : kNodes) {
    for (int j = 0; j < 6; ++j) {
      const GridNode node{i, j};
      EXPECT_NEAR(asked.Height(node), surface.NodeHeight(node), 1e-15) << i << ", " << j;
      EXPECT_EQ(asked.Layers(node).firm, surface.Layers(node).firm) << i << ", " << j;
      EXPECT_EQ(asked.Layers(node).moved, surface.Layers(node).moved) << i << ", " << j;
      EXPECT_EQ(asked.Layers(node).was_pressed, surface.Layers(node).was_pressed);
      if (before.NodeHeight(node) != surface.NodeHeight(node)) ++differ;
    }
  }
  EXPECT_EQ(differ, 4) << "all but that with deeper bearing sinkage";
}

TEST(CompactedSurface, TellsWhatIsDisplacedMore) {
  Surface surface = Driven();
  const double before = surface.DisplacedVolume();
  double more = 0;
  int nodes = 0;
  CompactedSurface(surface, kCompaction).ForEachDisplaced([&](NodeSoil soil) {
    EXPECT_LT(soil.thickness, 0);
    more += soil.thickness;
    ++nodes;
  });
  EXPECT_EQ(nodes, 2);
  for (const NodeSinkage& c : kCompaction) surface.SetCompaction(c);
  EXPECT_NEAR(surface.DisplacedVolume() - before, more * kDx * kDx, 1e-15);
}

TEST(CompactedSurface, WithoutAnotherCompactionIsTheSurface) {
  const Surface surface = Driven();
  for (const int i : kNodes) {
    EXPECT_NEAR(CompactedSurface(surface).Height({i, 2}), surface.NodeHeight({i, 2}), 1e-15);
  }
}

}  // namespace
}  // namespace softsoil
