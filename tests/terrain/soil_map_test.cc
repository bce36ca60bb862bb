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
  soil.compaction.initial_density = 950;
  soil.compaction.index = 450;
  soil.layers = {{0.2, 1000}};
  soil.concentration_factor = 6;
  return soil;
}

// Does not yield at all.
Soil Road() {
  Soil soil = Named("road");
  soil.compaction.initial_density = 1900;
  soil.concentration_factor = 3;
  return soil;
}

constexpr ColumnSettings kGrid{0.05, 0.05, 12};

struct Pressed {
  explicit Pressed(const SoilMap& soils) {
    std::vector<double> factors;
    for (int k = 0; k < soils.size(); ++k) factors.push_back(soils[k].concentration_factor);
    columns =
        Columns(soils, kGrid, FlatGround, MakeDirectStress({factors, 1.25 * kGrid.spacing, 1}));
    for (int k = 0; k < 3; ++k) {
      result = columns.Advance(LoadOf({{0, 0}, 0.2, 250e3}, kGrid.spacing), 0.01);
    }
  }
  double Sinkage(GridNode node) const {
    for (const NodeSinkage& c : result.compaction) {
      if (c.node.i == node.i && c.node.j == node.j) return c.sinkage;
    }
    return 0;
  }
  Columns columns;
  PeriodResult result;
};

// Columns know nothing of each other but for the load: so those of each soil must be as they are
// where that soil is everywhere, to the bit. Number of those that have sunk.
int ExpectAsAlone(const Pressed& ground, const Soil& soil, bool is_right) {
  const Pressed alone(soil);
  int sunk = 0;
  for (const NodeSinkage& c : alone.result.compaction) {
    if ((c.node.i > 0) != is_right || c.sinkage == 0) continue;
    EXPECT_EQ(ground.Sinkage(c.node), c.sinkage);
    EXPECT_EQ(ground.columns.Densities(c.node), alone.columns.Densities(c.node));
    ++sunk;
  }
  return sunk;
}

TEST(Columns, OfEachSoilCompactAsIfItWereEverywhere) {
  for (const Soil& left : {LooseSoil(), Road()}) {
    const Pressed ground(SoilMap(left, {Rectangle(Marsh(), {5.01, 0}, {5, 5})}));
    EXPECT_EQ(ExpectAsAlone(ground, left, false) > 20, left.name != "road");
    EXPECT_GT(ExpectAsAlone(ground, Marsh(), true), 20);
  }
}

}  // namespace
}  // namespace softsoil
