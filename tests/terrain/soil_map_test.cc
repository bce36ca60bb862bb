// Which soil lies where, and that ground of several soils is each of them where it lies.
#include "terrain/soil_map.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "terrain/input_error.h"
#include "tests/terrain/pressed_ground.h"

namespace softsoil {
namespace {

using Eigen::Vector2d;

Soil Named(const std::string& name) {
  Soil soil = LooseSoil();
  soil.name = name;
  return soil;
}

SoilRegion Rectangle(const Soil& soil, const Vector2d& centre, const Vector2d& half,
                     double yaw = 0) {
  return {soil, centre, Eigen::Rotation2Dd(yaw).toRotationMatrix() * half.asDiagonal()};
}

TEST(SoilMap, OfOneSoilHasItEverywhere) {
  const SoilMap soils(Named("loam"));
  EXPECT_EQ(soils.size(), 1);
  EXPECT_EQ(soils.At(1e6, -1e6).name, "loam");
}

TEST(SoilMap, HasTheSoilOfARegionWithinItsSides) {
  const SoilMap soils(Named("loam"), {Rectangle(Named("sand"), {1, 2}, {3, 0.5})});
  for (const double side : {-1.0, 1.0}) {
    EXPECT_EQ(soils.At(1 + side * 2.999, 2 + side * 0.499).name, "sand");
    EXPECT_EQ(soils.At(1 + side * 3.001, 2).name, "loam");
    EXPECT_EQ(soils.At(1, 2 + side * 0.501).name, "loam");
  }
}

TEST(SoilMap, MayHaveRegionsThatAreTurned) {
  const SoilMap soils(Named("loam"), {Rectangle(Named("sand"), {0, 0}, {2, 0.1}, kPi / 6)});
  EXPECT_EQ(soils.At(1.9 * std::cos(kPi / 6), 1.9 * std::sin(kPi / 6)).name, "sand");
  EXPECT_EQ(soils.At(1.9 * std::cos(kPi / 6), -1.9 * std::sin(kPi / 6)).name, "loam");
}

TEST(SoilMap, HasTheLastOfSeveralRegionsOnTop) {
  const SoilMap soils(Named("loam"), {Rectangle(Named("sand"), {0, 0}, {2, 2}),
                                      Rectangle(Named("clay"), {1, 0}, {2, 2})});
  EXPECT_EQ(soils.At(-1.5, 0).name, "sand");
  EXPECT_EQ(soils.At(0, 0).name, "clay");
  EXPECT_EQ(soils.At(2.5, 0).name, "clay");
}

TEST(SoilMap, RefusesARegionWithoutArea) {
  EXPECT_THROW(SoilMap(Named("loam"), {Rectangle(Named("sand"), {0, 0}, {2, 0})}), InputError);
  EXPECT_THROW(SoilMap(Named("loam"), {Rectangle(Named("sand"), {NAN, 0}, {2, 1})}), InputError);
}

// Looser, layered, and stress spreads less in it.
Soil Marsh() {
  Soil soil = Named("marsh");
  soil.compaction.initial_density = 1100;
  soil.compaction.index = 450;
  soil.layers = {{0.2, 1150}};
  soil.concentration_factor = 6;
  return soil;
}

constexpr ColumnSettings kGrid{0.05, 0.05, 12};

Columns Pressed(const SoilMap& soils, PeriodResult* result) {
  std::vector<double> factors;
  for (int k = 0; k < soils.size(); ++k) factors.push_back(soils[k].concentration_factor);
  Columns columns(soils, kGrid, FlatGround, MakeDirectStress({factors, 1.25 * kGrid.spacing, 1}));
  for (int k = 0; k < 3; ++k) {
    *result = columns.Advance(LoadOf({{0, 0}, 0.2, 250e3}, kGrid.spacing), 0.01);
  }
  return columns;
}

// Columns know nothing of each other but for the load: so those of each soil must be as they are
// where that soil is everywhere, to the bit.
TEST(Columns, OfEachSoilCompactAsIfItWereEverywhere) {
  const double border = 0.01;  // [m]  the marsh lies beyond
  const SoilMap both(LooseSoil(), {Rectangle(Marsh(), {border + 5, 0}, {5, 5})});
  PeriodResult in_both, in_loam, in_marsh;
  const Columns columns = Pressed(both, &in_both);
  const Columns loam = Pressed(LooseSoil(), &in_loam), marsh = Pressed(Marsh(), &in_marsh);

  int of_loam = 0, of_marsh = 0;
  for (const NodeSinkage& c : in_both.compaction) {
    const bool is_marsh = c.node.i * kGrid.spacing > border;
    const PeriodResult& alone = is_marsh ? in_marsh : in_loam;
    EXPECT_EQ(columns.Densities(c.node), (is_marsh ? marsh : loam).Densities(c.node));
    for (const NodeSinkage& other : alone.compaction) {
      if (other.node.i != c.node.i || other.node.j != c.node.j) continue;
      EXPECT_EQ(c.sinkage, other.sinkage);
      if (c.sinkage > 0) ++(is_marsh ? of_marsh : of_loam);
    }
  }
  EXPECT_GT(of_loam, 20);
  EXPECT_GT(of_marsh, of_loam);
  EXPECT_NE(columns.Densities({1, 0}), loam.Densities({1, 0}));
}

}  // namespace
}  // namespace softsoil
