#include "terrain/bearing.h"

#include <gtest/gtest.h>

namespace softsoil {
namespace {

const Bearing kLoam{6800, 1134e3, 0.85};

TEST(BearingPressure, NeverFallsAsThePlateSinks) {
  const double k_e = BearingModulus(kLoam, 0.4);
  double last = 0;
  for (double z = 0; z < 1; z += 0.001) {
    EXPECT_GE(BearingPressure(k_e, kLoam.n, z), last);
    last = BearingPressure(k_e, kLoam.n, z);
  }
  EXPECT_DOUBLE_EQ(BearingPressure(k_e, kLoam.n, 1), 1134e3 + 6800 / 0.4);
}

TEST(BearingPressure, IsAbsentAboveTheGround) {
  EXPECT_EQ(BearingPressure(1e6, 0.85, 0), 0);
  EXPECT_EQ(BearingPressure(1e6, 0.85, -0.1), 0);
}

TEST(BearingPressure, OfANarrowerPlateIsHigherInCohesiveSoil) {
  EXPECT_GT(BearingModulus(kLoam, 0.2), BearingModulus(kLoam, 0.4));
}

TEST(BearingSlope, IsThatOfFiniteDifferences) {
  const double k_e = BearingModulus(kLoam, 0.4), e = 1e-7;
  for (double z : {0.01, 0.05, 0.3}) {
    const double slope =
        (BearingPressure(k_e, kLoam.n, z + e) - BearingPressure(k_e, kLoam.n, z - e)) / (2 * e);
    const double pressure = BearingPressure(k_e, kLoam.n, z);
    EXPECT_NEAR(BearingSlope(pressure, kLoam.n, z) / slope, 1, 1e-6);
  }
}

}  // namespace
}  // namespace softsoil
