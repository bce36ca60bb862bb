#include "contact/tire_nodes.h"

#include <gtest/gtest.h>

#include <numeric>

#include "terrain/point_load.h"
#include "tests/contact/samples.h"

namespace softsoil {
namespace {

double TotalArea(const TireNodes& nodes) {
  return std::accumulate(nodes.area.begin(), nodes.area.end(), 0.0);
}

// Area of the tread [m^2]: the arc of the crown swept around the axis.
double TorusTread(const TireShape& s) {
  const double beta = std::asin(s.width / (2 * s.crown_radius));
  return 4 * kPi * s.crown_radius *
         ((s.radius - s.crown_radius) * beta + s.crown_radius * std::sin(beta));
}

TEST(TireNodes, CoverACylinderExactly) {
  const TireShape shape = TruckTire().shape;
  for (double spacing : {0.1, 0.025, 0.007}) {
    EXPECT_NEAR(TotalArea(MakeTireNodes(shape, spacing)), 2 * kPi * shape.radius * shape.width,
                1e-12);
  }
}

TEST(TireNodes, CoverATorusBetterTheCloserTheyStand) {
  const TireShape shape = AgriculturalTire().shape;
  const double coarse = TotalArea(MakeTireNodes(shape, 0.08)) / TorusTread(shape) - 1;
  const double fine = TotalArea(MakeTireNodes(shape, 0.02)) / TorusTread(shape) - 1;
  EXPECT_LT(std::abs(coarse), 1e-3);
  EXPECT_LT(std::abs(fine), std::abs(coarse) / 8);  // second order
}

TEST(TireNodes, HaveRightAngledUnitFrames) {
  const TireNodes nodes = MakeTireNodes(AgriculturalTire().shape, 0.05);
  ASSERT_GT(nodes.size(), 500u);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    Eigen::Matrix3d frame;
    frame << nodes.normal_t[i], nodes.tangent_t[i], nodes.binormal_t[i];
    EXPECT_TRUE(frame.isUnitary(1e-12)) << i;
    EXPECT_NEAR(frame.determinant(), 1, 1e-12) << i;
    EXPECT_NEAR(nodes.radial_t[i].norm(), 1, 1e-12) << i;
    EXPECT_NEAR(nodes.radial_t[i].dot(nodes.tangent_t[i]), 0, 1e-12) << i;
    EXPECT_EQ(nodes.radial_t[i].y(), 0) << i;
  }
}

TEST(TireNodes, LieOnTheTireWithTheirNormalsOutward) {
  for (const Tire& tire : {AgriculturalTire(), TruckTire()}) {
    const TireNodes nodes = MakeTireNodes(tire.shape, 0.03);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const Eigen::Vector3d& p = nodes.position_t[i];
      EXPECT_NEAR(nodes.radius[i], RadiusAt(tire.shape, p.y()), 1e-12);
      EXPECT_NEAR(p.dot(nodes.radial_t[i]), nodes.radius[i], 1e-12);
      EXPECT_LT(std::abs(p.y()), tire.shape.width / 2);
      EXPECT_GT(nodes.normal_t[i].dot(nodes.radial_t[i]), 0.9);
      EXPECT_GE(nodes.normal_t[i].y() * p.y(), 0);
    }
  }
}

// The normal must be that of the surface, not only perpendicular to the circumference.
TEST(TireNodes, HaveTheNormalOfTheCrown) {
  const TireShape shape = AgriculturalTire().shape;
  const TireNodes nodes = MakeTireNodes(shape, 0.03);
  const double e = 1e-6;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const double y = nodes.position_t[i].y();
    const double slope = (RadiusAt(shape, y + e) - RadiusAt(shape, y - e)) / (2 * e);
    EXPECT_NEAR(nodes.normal_t[i].y() / nodes.normal_t[i].dot(nodes.radial_t[i]), -slope, 1e-8);
  }
}

TEST(TireNodes, StandAboutTheirSpacingApart) {
  const TireShape shape = TruckTire().shape;
  const TireNodes nodes = MakeTireNodes(shape, 0.025);
  EXPECT_NEAR(TotalArea(nodes) / nodes.size(), 0.025 * 0.025, 0.05 * 0.025 * 0.025);
}

TEST(TireNodes, AreStillACircleWhereTheSpacingIsLargerThanTheTire) {
  const TireNodes nodes = MakeTireNodes(TruckTire().shape, 10);
  EXPECT_EQ(nodes.size(), 24u);
}

TEST(LoadedArea, ShrinksWithTheRadius) {
  EXPECT_DOUBLE_EQ(LoadedArea(2, 0.5, 0), 2);
  EXPECT_DOUBLE_EQ(LoadedArea(2, 0.5, 0.1), 1.6);
  EXPECT_DOUBLE_EQ(LoadedArea(2, 0.5, 0.5), 0);
}

TEST(RadiusAt, EndsWithTheTread) {
  const TireShape shape = AgriculturalTire().shape;
  EXPECT_EQ(RadiusAt(shape, 0), shape.radius);
  EXPECT_EQ(RadiusAt(shape, 0.2), RadiusAt(shape, -0.2));
  EXPECT_GT(RadiusAt(shape, 0.2334), 0.8);
  EXPECT_EQ(RadiusAt(shape, 0.2336), 0);
}

}  // namespace
}  // namespace softsoil
