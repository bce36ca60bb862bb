// Columns::Advance visits only those columns that a load can compact. Skipping is exact: in every
// skipped volume the stress, worked out by the oracle, stays below the yield stress.
#include <gtest/gtest.h>

#include <set>
#include <utility>

#include "terrain/columns.h"
#include "tests/terrain/pressed_ground.h"
#include "tests/terrain/stress_case.h"

namespace softsoil {
namespace {

using softsoil_reference::StressInCones;

constexpr ColumnSettings kGrid{0.05, 0.05, 24};
constexpr double kYield = 96e3;  // [Pa]

double MostStress(const std::vector<softsoil_reference::Force>& forces, GridNode node) {
  double most = 0;
  for (int k = 0; k < kGrid.volumes; ++k) {
    const double z = -(k + 0.5) * kGrid.volume_height;
    most = std::max(most,
                    StressInCones(forces, 5, {node.i * kGrid.spacing, node.j * kGrid.spacing, z}));
  }
  return most;
}

// Two circles that push sideways too; between them their stresses add up.
SurfaceLoad TwoCircles() {
  SurfaceLoad load = LoadOf({{0, 0}, 0.2, 250e3}, kGrid.spacing, 0);
  const SurfaceLoad second = LoadOf({{12, 3}, 0.15, 400e3}, kGrid.spacing, 1);
  load.insert(load.end(), second.begin(), second.end());
  for (NodeForce& f : load) f.force_w += Eigen::Vector3d(150, -80, 0);
  return load;
}

TEST(SkippedColumns, WouldNotHaveYielded) {
  const SurfaceLoad load = TwoCircles();
  Columns columns = FlatColumns(kGrid);
  std::set<std::pair<int, int>> visited;
  for (const NodeSinkage& s : columns.Advance(load, 0.01).compaction) {
    visited.insert({s.node.i, s.node.j});
  }
  int skipped = 0, yielding = 0;
  for (int i = -25; i <= 35; ++i) {
    for (int j = -25; j <= 25; ++j) {
      const double stress = MostStress(ForOracle(load), {i, j});
      if (visited.count({i, j}) != 0) {
        yielding += stress > kYield ? 1 : 0;
        continue;
      }
      ++skipped;
      ASSERT_LT(stress, kYield) << i << ", " << j;
    }
  }
  EXPECT_GT(skipped, 1000);
  EXPECT_GT(yielding, 50);
}

// Under a single force the bound is tight: the columns visited are just those that yield.
TEST(SkippedColumns, WouldNotHaveYieldedBesideASingleForce) {
  const double dx = 0.01;
  const SurfaceLoad load{ForceAt({0, 0}, dx, 0, {0, 0, -8e3})};
  Columns columns = FlatColumns({dx, dx, 60});
  std::set<std::pair<int, int>> visited;
  for (const NodeSinkage& s : columns.Advance(load, 0.01).compaction) {
    visited.insert({s.node.i, s.node.j});
  }
  const auto most = [&](int i, int j) {
    double stress = 0;
    for (double z = -0.005; z > -0.6; z -= 0.01) {
      stress = std::max(stress, StressInCones(ForOracle(load), 5, {i * dx, j * dx, z}));
    }
    return stress;
  };
  for (int i = -20; i <= 20; ++i) {
    for (int j = -20; j <= 20; ++j) {
      if (most(i, j) > kYield) {
        EXPECT_EQ(visited.count({i, j}), 1u) << i << ", " << j;
      }
      if (most(i, j) < 0.9 * kYield) {
        EXPECT_EQ(visited.count({i, j}), 0u) << i << ", " << j;
      }
    }
  }
  EXPECT_GT(visited.size(), 200u);
}

// Beyond the circles too, so not just their own columns are visited.
TEST(SkippedColumns, AreNotThoseBesideTheLoadThatYield) {
  SurfaceLoad load = LoadOf({{0, 0}, 0.2, 1000e3}, kGrid.spacing);
  Columns columns = FlatColumns(kGrid);
  columns.Advance(load, 0.01);
  ASSERT_GT(MostStress(ForOracle(load), {6, 0}), 1.2 * kYield);
  const std::vector<double> beside = columns.Densities({6, 0});
  EXPECT_GT(*std::max_element(beside.begin(), beside.end()), 1201);
}

// Energy is stress times strain times volume, summed over all volumes.
TEST(SkippedColumns, WouldAddNoEnergy) {
  const SurfaceLoad load = TwoCircles();
  Columns columns = FlatColumns(kGrid);
  const PeriodResult result = columns.Advance(load, 0.01);
  const auto forces = ForOracle(load);
  std::set<std::pair<int, int>> loaded;
  for (const NodeForce& f : load) loaded.insert({f.node.i, f.node.j});
  double energy = 0, checked = 0;
  for (const NodeSinkage& s : result.compaction) {
    const std::vector<double> densities = columns.Densities(s.node);
    for (int k = 1; k < kGrid.volumes; ++k) {  // the topmost lies in the near field
      const double stress =
          StressInCones(forces, 5, {s.node.i * 0.05, s.node.j * 0.05, -(k + 0.5) * 0.05});
      energy += stress * (1 - 1200 / densities[k]) * 0.05 * 0.05 * 0.05;
    }
    if (loaded.count({s.node.i, s.node.j}) == 0) continue;
    const double pressure = s.node.i < 6 ? 250e3 : 400e3;
    checked += pressure * (1 - 1200 / densities[0]) * 0.05 * 0.05 * 0.05;
  }
  ASSERT_EQ(result.energy.size(), 2u);
  EXPECT_GT(checked, 0.05 * energy);
  EXPECT_NEAR(result.energy[0] + result.energy[1], energy + checked, 1e-3 * energy);
}

}  // namespace
}  // namespace softsoil
