// A lattice of point loads is right only some way below the surface; nearer to a force a volume
// takes the surface pressure of its own column (3.13).
#include <gtest/gtest.h>

#include "tests/terrain/stress_case.h"

namespace softsoil {
namespace {

constexpr double kDx = 0.025;         // [m]
constexpr double kNear = 1.25 * kDx;  // [m]

// Two columns, above node (0, 0) and its neighbour, that bear different pressures.
ColumnBatch TwoColumns() {
  ColumnBatch batch = Block({0, 0}, 2, kDx, 10, kDx, 0);
  batch.surface_pressure = {70e3, 30e3, 0, 0};
  return batch;
}

const SurfaceLoad kLoad{ForceAt({0, 0}, kDx, 0, {0, 0, -70e3 * kDx* kDx}),
                        ForceAt({0, 1}, kDx, 0, {0, 0, -30e3 * kDx* kDx})};

TEST(NearField, TakesTheSurfacePressureOfItsOwnColumn) {
  const std::vector<float> stress = Stress({{5}, kNear, 1}, TwoColumns(), kLoad);
  EXPECT_EQ(stress[0], 70e3f);  // dx/2 below its own node
  EXPECT_EQ(stress[10], 30e3f);
}

TEST(NearField, IsAbsentFurtherFromEveryForce) {
  const ColumnBatch batch = TwoColumns();
  const std::vector<float> stress = Stress({{5}, kNear, 1}, batch, kLoad);
  const std::vector<double> expected = OracleStress(5, batch, kLoad);
  for (int k = 1; k < 10; ++k) EXPECT_NEAR(stress[k], expected[k], 0.5) << k;  // 1.5 dx and deeper
}

TEST(NearField, ReachesNeighboursWithoutLoadOfTheirOwn) {
  const std::vector<float> stress = Stress({{5}, kNear, 1}, TwoColumns(), kLoad);
  EXPECT_EQ(stress[20], 0);  // sqrt(dx^2 + (dx/2)^2) = 1.12 dx from node (0, 0)
  EXPECT_GT(stress[21], 0);
}

// Why it is needed: this close the own node alone gives 2.5 times its pressure.
TEST(NearField, IsWhereOneNodeAloneGivesMoreThanItsPressure) {
  const SurfaceLoad one{ForceAt({0, 0}, kDx, 0, {0, 0, -1e3 * kDx * kDx})};
  EXPECT_GT(Stress({{4}, 1e-6, 1}, TwoColumns(), one)[0], 2.5e3);
}

TEST(NearField, DoesNotReachAboveAForce) {
  const SurfaceLoad load{ForceAt({0, 0}, kDx, -0.025, {0, 0, -1e3})};
  EXPECT_EQ(Stress({{5}, kNear, 1}, TwoColumns(), load)[0], 0);
}

}  // namespace
}  // namespace softsoil
