#include "terrain/columns.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "tests/terrain/pressed_ground.h"

namespace softsoil {
namespace {

constexpr ColumnSettings kGrid{0.05, 0.05, 24};
constexpr double kPeriod = 0.01;  // [s]
const Circle kPlate{{0, 0}, 0.2, 250e3};

// Presses for `periods` and takes the load off again for one.
PeriodResult Pressed(Columns& columns, const SurfaceLoad& load, int periods) {
  PeriodResult result;
  for (int i = 0; i < periods; ++i) result = columns.Advance(load, kPeriod);
  return result;
}

double SinkageAt(const PeriodResult& result, GridNode node) {
  for (const NodeSinkage& s : result.compaction) {
    if (s.node.i == node.i && s.node.j == node.j) return s.sinkage;
  }
  return 0;
}

TEST(Columns, SinkUnderALoadedCircle) {
  Columns columns = FlatColumns(kGrid);
  const PeriodResult result = Pressed(columns, LoadOf(kPlate, kGrid.spacing), 50);
  EXPECT_GT(SinkageAt(result, {0, 0}), 0.02);
  EXPECT_LT(SinkageAt(result, {0, 0}), 0.2);
  EXPECT_GT(SinkageAt(result, {0, 0}), SinkageAt(result, {4, 0}));
  EXPECT_GT(SinkageAt(result, {4, 0}), SinkageAt(result, {6, 0}));
}

TEST(Columns, SinkAlikeOnAllSidesOfALoadedCircle) {
  Columns columns = FlatColumns(kGrid);
  const PeriodResult result = Pressed(columns, LoadOf(kPlate, kGrid.spacing), 20);
  const double east = SinkageAt(result, {3, 1});
  EXPECT_GT(east, 0.01);
  EXPECT_NEAR(SinkageAt(result, {-3, 1}), east, 1e-6);
  EXPECT_NEAR(SinkageAt(result, {-1, -3}), east, 1e-6);
}

TEST(Columns, CompactMostBelowTheNearField) {
  Columns columns = FlatColumns(kGrid);
  Pressed(columns, LoadOf(kPlate, kGrid.spacing), 50);
  const std::vector<double> densities = columns.Densities({0, 0});
  ASSERT_EQ(densities.size(), 24u);
  EXPECT_EQ(*std::max_element(densities.begin(), densities.begin() + 3),
            *std::max_element(densities.begin(), densities.end()));
  EXPECT_TRUE(std::is_sorted(densities.rbegin(), densities.rend() - 2));
  EXPECT_GT(densities[2], densities[8] + 10);
  EXPECT_EQ(densities.back(), 1200);
}

// Mass over area, in initial height times initial density, stands at a height that its densities
// give.
TEST(Columns, ConserveMass) {
  Columns columns = FlatColumns(kGrid);
  const PeriodResult result = Pressed(columns, LoadOf(kPlate, kGrid.spacing), 50);
  for (const NodeSinkage& s : result.compaction) {
    double height = 0;
    for (double density : columns.Densities(s.node)) height += kGrid.volume_height * 1200 / density;
    ASSERT_NEAR(s.sinkage, kGrid.volumes * kGrid.volume_height - height, 1e-12);
  }
  EXPECT_GT(result.compaction.size(), 50u);
}

TEST(Columns, KeepTheirDensityWithoutLoad) {
  Columns columns = FlatColumns(kGrid);
  EXPECT_TRUE(Pressed(columns, {}, 100).compaction.empty());
  EXPECT_EQ(columns.column_count(), 0u);
  EXPECT_EQ(columns.MemoryBytes(), 0u);
}

TEST(Columns, KeepTheirDensityUnderLessThanTheYieldStress) {
  Columns columns = FlatColumns(kGrid);
  const PeriodResult result = Pressed(columns, LoadOf({{0, 0}, 0.2, 90e3}, kGrid.spacing), 50);
  EXPECT_FALSE(result.compaction.empty());
  for (const NodeSinkage& s : result.compaction) EXPECT_EQ(s.sinkage, 0);
}

TEST(Columns, RiseALittleWhenTheLoadIsTakenOff) {
  Columns columns = FlatColumns(kGrid);
  const PeriodResult pressed = Pressed(columns, LoadOf(kPlate, kGrid.spacing), 50);
  const PeriodResult freed = columns.Advance({}, kPeriod);
  const double sinkage = SinkageAt(pressed, {0, 0});
  EXPECT_LT(SinkageAt(freed, {0, 0}), sinkage);
  EXPECT_GT(SinkageAt(freed, {0, 0}), 0.5 * sinkage);
}

// Columns whose load cycle is open are visited although no load reaches them any more; then never.
TEST(Columns, AreVisitedUntilTheirLoadCycleHasEnded) {
  Columns columns = FlatColumns(kGrid);
  Pressed(columns, LoadOf(kPlate, kGrid.spacing), 5);
  EXPECT_GT(columns.Advance({}, kPeriod).compaction.size(), 40u);
  for (int period = 0; period < 10; ++period) columns.Advance({}, kPeriod);
  EXPECT_TRUE(columns.Advance({}, kPeriod).compaction.empty());
}

TEST(Columns, HardenFromLoadToLoad) {
  Columns columns = FlatColumns(kGrid);
  double last = 0, last_gain = 1;
  for (int pass = 0; pass < 4; ++pass) {
    Pressed(columns, LoadOf(kPlate, kGrid.spacing), 20);
    const double sinkage = SinkageAt(columns.Advance({}, kPeriod), {0, 0});
    EXPECT_GT(sinkage, last);
    EXPECT_LT(sinkage - last, last_gain);
    last_gain = sinkage - last;
    last = sinkage;
  }
}

TEST(Columns, TellThatTheyAreTooShort) {
  Columns tall = FlatColumns(kGrid), small = FlatColumns({0.05, 0.05, 4});
  EXPECT_FALSE(Pressed(tall, LoadOf(kPlate, 0.05), 10).lowest_volume_yields);
  EXPECT_TRUE(Pressed(small, LoadOf(kPlate, 0.05), 10).lowest_volume_yields);
}

TEST(Columns, HaveTheSameBitsOnAnyNumberOfThreads) {
  Columns one = FlatColumns(kGrid, 1), two = FlatColumns(kGrid, 2);
  const PeriodResult a = Pressed(one, LoadOf(kPlate, kGrid.spacing), 20);
  const PeriodResult b = Pressed(two, LoadOf(kPlate, kGrid.spacing), 20);
  ASSERT_EQ(a.compaction.size(), b.compaction.size());
  for (std::size_t i = 0; i < a.compaction.size(); ++i) {
    ASSERT_EQ(a.compaction[i].sinkage, b.compaction[i].sinkage);
    ASSERT_EQ(one.Densities(a.compaction[i].node), two.Densities(b.compaction[i].node));
  }
  EXPECT_EQ(a.energy, b.energy);
  EXPECT_GT(a.energy.at(0), 0);
}

TEST(Columns, TakeAtMost24BytesPerVolumeAnd200PerColumn) {
  Columns columns = FlatColumns(kGrid);
  Pressed(columns, LoadOf(kPlate, kGrid.spacing), 1);
  ASSERT_GT(columns.column_count(), 0u);
  const std::size_t beside = columns.MemoryBytes() - columns.VolumeBytes();
  RecordProperty("bytes_per_volume", columns.VolumeBytes() / columns.volume_count());
  RecordProperty("bytes_per_column", beside / columns.column_count());
  EXPECT_LE(columns.VolumeBytes(), 24 * columns.volume_count());
  EXPECT_LE(beside, 200 * columns.column_count());
}

TEST(Columns, OfUntouchedGroundAreNotThere) {
  Columns columns = FlatColumns(kGrid);
  Pressed(columns, LoadOf(kPlate, kGrid.spacing), 1);
  EXPECT_TRUE(columns.Densities({1000, 0}).empty());
  EXPECT_EQ(columns.column_count(), 4u * 256);
}

// The place on the grid does not matter, nor does the height of the ground.
TEST(Columns, CompactTheSameEverywhere) {
  const Soil soil = LooseSoil();
  Columns here = FlatColumns(kGrid);
  Columns there(
      soil, kGrid, [](double, double) { return 250.0; },
      MakeDirectStress({{soil.concentration_factor}, 1.25 * kGrid.spacing, 1}));
  SurfaceLoad moved = LoadOf({{-20011, 30007}, kPlate.radius, kPlate.pressure}, kGrid.spacing);
  for (NodeForce& f : moved) f.z = 250;
  Pressed(here, LoadOf(kPlate, kGrid.spacing), 20);
  Pressed(there, moved, 20);
  const std::vector<double> a = here.Densities({2, 1}), b = there.Densities({-20009, 30008});
  ASSERT_EQ(a.size(), b.size());
  EXPECT_GT(a[1], 1210);
  for (std::size_t k = 0; k < a.size(); ++k) EXPECT_NEAR(a[k], b[k], 1e-3) << k;
}

}  // namespace
}  // namespace softsoil
