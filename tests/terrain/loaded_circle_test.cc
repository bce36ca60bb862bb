#include <gtest/gtest.h>

#include "tests/terrain/stress_case.h"

namespace softsoil {
namespace {

using softsoil_reference::StressUnderCircle;

constexpr double kDx = 0.005;        // [m]  fine against the circle
constexpr double kRadius = 0.2;      // [m]
constexpr double kPressure = 100e3;  // [Pa]

// A circle under uniform pressure on the nodes inside it, scaled to the exact load.
SurfaceLoad Circle() {
  SurfaceLoad load;
  const int n = static_cast<int>(kRadius / kDx);
  for (int i = -n; i <= n; ++i) {
    for (int j = -n; j <= n; ++j) {
      if ((i * i + j * j) * kDx * kDx > kRadius * kRadius) continue;
      load.push_back(ForceAt({i, j}, kDx, 0, {0, 0, 0}));
    }
  }
  const double total = kPressure * std::acos(-1.0) * kRadius * kRadius;
  for (NodeForce& f : load) f.force_w.z() = -total / load.size();
  return load;
}

TEST(LoadedCircle, PressesOnItsAxisAsInTheClosedForm) {
  const SurfaceLoad load = Circle();
  const ColumnBatch axis = Block({0, 0}, 1, kDx, 60, 0.01, 0);
  for (double nu : {3.0, 4.0, 4.5, 5.0, 6.0}) {
    const std::vector<float> stress = Stress({{nu}, 1.25 * kDx, 1}, axis, load);
    const double whole_in_cone = kRadius / std::sqrt(nu + 1);  // above it the rim is cut off
    int compared = 0;
    for (int k = 0; k < 60; ++k) {
      const double depth = -axis.z[k];
      if (depth < whole_in_cone) continue;
      const double expected = StressUnderCircle(kPressure, nu, kRadius, depth);
      EXPECT_NEAR(stress[k], expected, 0.005 * kPressure) << "nu " << nu << " depth " << depth;
      ++compared;
    }
    EXPECT_GT(compared, 40);
  }
}

// Nearer the surface the cone cuts off the rim, which never adds more than this.
TEST(LoadedCircle, LosesTheKnownShareWhereTheConeCutsOffItsRim) {
  const SurfaceLoad load = Circle();
  const ColumnBatch axis = Block({0, 0}, 1, kDx, 60, 0.01, 0);
  const double nu = 5;
  const std::vector<float> stress = Stress({{nu}, 1.25 * kDx, 1}, axis, load);
  for (int k = 2; (k + 0.5) * 0.01 < kRadius / std::sqrt(nu + 1); ++k) {
    EXPECT_NEAR(stress[k], kPressure * softsoil_reference::ShareInsideCone(nu), 0.02 * kPressure);
  }
}

TEST(LoadedCircle, PressesTheNearFieldWithItsPressure) {
  ColumnBatch axis = Block({0, 0}, 1, 0.025, 10, 0.0125, 0);
  axis.surface_pressure = {kPressure};
  EXPECT_EQ(Stress({{5}, 1.25 * 0.025, 1}, axis, Circle())[0], float(kPressure));
}

// The backend leaves out what lies outside the cone; so much passes a plane and no more.
TEST(LoadedCircle, CarriesTheShareInsideTheConesThroughAPlane) {
  const SurfaceLoad load{ForceAt({0, 0}, kDx, 0, {700, -300, -1e3})};
  for (double nu : {3.0, 4.5, 6.0}) {
    const double depth = 0.15;
    const ColumnBatch plane = Block({-90, -90}, 181, kDx, 1, 2 * depth, 0);
    double carried = 0;
    for (float stress : Stress({{nu}, 1e-6, 1}, plane, load)) carried += stress * kDx * kDx;
    EXPECT_NEAR(carried, 1e3 * softsoil_reference::ShareInsideCone(nu), 1) << nu;
  }
}

}  // namespace
}  // namespace softsoil
