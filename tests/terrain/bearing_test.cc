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

// p = (k_1 + k_2 b) (z/b)^n with compact sand of Wong and Reece (1967), in pounds and inches: 20
// psi, 2.5 psi/in, n 0.47 under a 6 in plate pressed 3 in deep.
TEST(BearingPressure, InTheFormOfReeceScalesWithThePlate) {
  const Bearing sand{20, 2.5, 0.47, BearingForm::kReece};
  EXPECT_NEAR(BearingPressure(BearingModulus(sand, 6), sand.n, 3), 35 * std::pow(0.5, 0.47), 1e-9);
  EXPECT_NEAR(BearingPressure(BearingModulus(sand, 12), sand.n, 6), 50 * std::pow(0.5, 0.47), 1e-9);
}

// The two forms meet where their moduli do: k_1 b^-n = k_c/b for n = 1.
TEST(BearingPressure, OfBekkerAndReeceAgreeForALinearSoil) {
  const Bearing bekker{5000, 8e5, 1}, reece{5000, 8e5, 1, BearingForm::kReece};
  for (double b : {0.1, 0.3, 0.7}) {
    EXPECT_NEAR(BearingModulus(bekker, b), BearingModulus(reece, b), 1e-9 * 8e5) << b;
  }
}

}  // namespace
}  // namespace softsoil
