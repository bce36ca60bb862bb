#include "terrain/plate_curve.h"

#include <gtest/gtest.h>

namespace softsoil {
namespace {

// A sand that bears as LETE sand in the catalogue and springs back.
constexpr Unloading kSandUnloading{0, 503e6};
const PlateCurve kSand = CurveUnder({102e3, 5301e3, 0.79}, kSandUnloading, 0.3);
const PlateCurve kRigid = CurveUnder({102e3, 5301e3, 0.79}, {}, 0.3);

// From stiff to soft springing back, exponents on both sides of 1.
std::vector<PlateCurve> Curves() {
  std::vector<PlateCurve> curves;
  for (double n : {0.2, 0.79, 1.0, 1.6, 2.5}) {
    for (Unloading u : {Unloading{0, 503e6}, Unloading{5e6, 0}, Unloading{1e9, 1e8}}) {
      curves.push_back({2e6, n, u});
    }
  }
  return curves;
}

// p = p_u - k_u (z_u - z), k_u = k_0 + A_u z_u.
TEST(Unloading, FollowsTheStraightLineOfWong) {
  const double z_u = 0.08, p_u = BearingPressure(kSand.k_e, kSand.n, z_u), k_u = 503e6 * z_u;
  const double z_r = ResidualDepth(kSand, z_u);
  EXPECT_NEAR(z_r, z_u - p_u / k_u, 1e-15);
  const PlaceInSoil place = PlaceAt(kSand, z_r);
  EXPECT_NEAR(place.z_u, z_u, 1e-9);
  for (double z : {0.062, 0.07, 0.079}) {
    EXPECT_NEAR(PressureAt(place, z).value, p_u - k_u * (z_u - z), 1e-6 * p_u) << z;
  }
}

TEST(Unloading, ReloadsToTheVirginCurveAndGoesOnAlongIt) {
  for (const PlateCurve& curve : Curves()) {
    const PlaceInSoil place = PlaceAt(curve, ResidualDepth(curve, 0.1));
    const double virgin = BearingPressure(curve.k_e, curve.n, place.z_u);
    EXPECT_NEAR(PressureAt(place, place.z_u * (1 - 1e-12)).value, virgin, 1e-6 * virgin);
    EXPECT_DOUBLE_EQ(PressureAt(place, 0.2).value, BearingPressure(curve.k_e, curve.n, 0.2));
  }
}

TEST(Unloading, LeavesADepthFromWhichItTurnsWhereItTurned) {
  for (const PlateCurve& curve : Curves()) {
    for (double z_u : {0.005, 0.05, 0.3}) {
      const double z_r = ResidualDepth(curve, z_u);
      EXPECT_NEAR(TurningDepth(curve, z_r), z_u, 1e-9) << curve.n;
    }
  }
}

TEST(Unloading, NeverHeavesAboveTheUndisturbedGroundNorBackAfterAGreaterLoad) {
  for (const PlateCurve& curve : Curves()) {
    double last = 0;
    for (double z = 1e-4; z < 1; z *= 1.1) {
      const double residual = ResidualDepth(curve, z);
      EXPECT_GE(residual, last - 1e-12) << curve.n << ' ' << z;
      EXPECT_LE(residual, z);
      last = residual;
    }
  }
}

TEST(Unloading, OfSoilThatIsRigidLeavesAll) {
  EXPECT_EQ(ResidualDepth(kRigid, 0.08), 0.08);
  EXPECT_EQ(TurningDepth(kRigid, 0.08), 0.08);
  const PlaceInSoil place = PlaceAt(kRigid, 0.08);
  EXPECT_EQ(PressureAt(place, 0.08).value, BearingPressure(kRigid.k_e, kRigid.n, 0.08));
}

TEST(Unloading, GivesBackHalfOfTheSinkageAtMost) {
  const PlateCurve soft{1e6, 1.0, {1e5, 0}};
  EXPECT_DOUBLE_EQ(ResidualDepth(soft, 0.1), 0.05);
  EXPECT_NEAR(PressureAt(PlaceAt(soft, 0.05), 0.075).value, 0.5e5, 1);
}

}  // namespace
}  // namespace softsoil
