#include "terrain/shear.h"

#include <gtest/gtest.h>

#include <random>

namespace softsoil {
namespace {

const Shear kLoam{7100, 0.37, 0.0106};
constexpr double kK = 0.0106;  // [m]

double Length(Mobilisation m) { return std::hypot(m.t, m.b); }

TEST(ShearStrength, IsTheLessOfMohrCoulombAndFriction) {
  EXPECT_DOUBLE_EQ(ShearStrength(kLoam, 0.6, 10e3), 6e3);
  EXPECT_DOUBLE_EQ(ShearStrength(kLoam, 0.6, 100e3), 7100 + 100e3 * std::tan(0.37));
}

TEST(ShearStrength, IsAbsentWithoutPressure) {
  EXPECT_EQ(ShearStrength(kLoam, 0.6, 0), 0);
  EXPECT_EQ(ShearStrength(kLoam, 0.6, -1e3), 0);
}

// Janosi and Hanamoto: 1 - exp(-j/K) after slipping j.
TEST(Slip, AtOneDirectionIsJanosiHanamotoForAnyStep) {
  for (double h : {1e-4, 1e-3, 1e-2}) {
    Mobilisation m{0, 0};
    for (double t = h / 2; t < 0.1; t += h) m = Slip(m, 0.18, -0.24, h, kK);
    EXPECT_NEAR(Length(m), 1 - std::exp(-0.03 / kK), 1e-9) << h;
    EXPECT_NEAR(m.t / m.b, -0.75, 1e-9);
  }
}

TEST(Slip, UnloadsAndReversesWhenItTurnsBack) {
  const Mobilisation forward = Slip({0, 0}, 1, 0, 5 * kK, kK);
  ASSERT_GT(forward.t, 0.99);
  const Mobilisation half = Slip(forward, -1, 0, 0.5 * kK, kK),
                     back = Slip(forward, -1, 0, 5 * kK, kK);
  EXPECT_LT(half.t, 0.5);
  EXPECT_LT(back.t, -0.98);
}

TEST(Slip, NeverMobilisesMoreThanTheStrength) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> speed(-5, 5), step(1e-5, 1);
  Mobilisation m{0, 0};
  for (int i = 0; i < 10000; ++i) {
    m = Slip(m, speed(random), speed(random), step(random), kK);
    ASSERT_LE(Length(m), 1 + 1e-12);
  }
}

TEST(SlipSinkage, IsAShareOfTheShearWorkPerPressure) {
  EXPECT_DOUBLE_EQ(SlipSinkage(0.3, 0.5, {0.6, -0.8}, 0.02), 0.3 * 0.5 * 0.02);
  EXPECT_DOUBLE_EQ(SlipSinkage(0.3, 0.5, {0.3, 0.4}, 0.02), 0.3 * 0.5 * 0.02 / 4);
  EXPECT_EQ(SlipSinkage(0.3, 0.5, {0, 0}, 0.02), 0);
}

TEST(Slip, IsKeptAtRest) {
  const Mobilisation m = Slip({0.3, -0.4}, 0, 0, 1, kK);
  EXPECT_EQ(m.t, 0.3);
  EXPECT_EQ(m.b, -0.4);
}

// Shear stress against strength after slipping straight on by j [m].
double Mobilised(const Shear& soil, double j, int steps = 50) {
  Mobilisation m{0, 0};
  for (int i = 0; i < steps; ++i) m = Slip(m, 0.6 * j, 0.8 * j, 1.0 / steps, soil.modulus);
  return Length(m) * HumpFactor(soil, m.slip);
}

constexpr Shear Humped(double residual) { return {7100, 0.37, kK, ShearForm::kHumped, residual}; }

TEST(HumpedShear, IsEquation2_8OnAStraightSlip) {
  for (double x : {1e-6, 0.1, 0.5, 0.999, 1.001, 2.0, 5.0}) {
    EXPECT_NEAR(Mobilised(Humped(0), x * kK), x * std::exp(1 - x), 1e-9) << x;
  }
}

TEST(HumpedShear, PeaksAtTheStrengthAndFallsToTheResidual) {
  EXPECT_NEAR(Mobilised(Humped(0.4), kK), 1, 1e-9);
  EXPECT_LT(Mobilised(Humped(0.4), 0.9 * kK), 1);
  EXPECT_LT(Mobilised(Humped(0.4), 1.1 * kK), 1);
  EXPECT_NEAR(Mobilised(Humped(0.4), 40 * kK), 0.4, 1e-9);
  EXPECT_NEAR(Mobilised(Humped(1), 3 * kK), 1, 1e-9);  // no fall at all
}

TEST(HumpedShear, DoesNotHealWhenTheSlipReverses) {
  const Shear soil = Humped(0.4);
  Mobilisation m = Slip({0, 0}, 1, 0, 10 * kK, kK);
  m = Slip(m, -1, 0, 2 * kK, kK);
  EXPECT_LT(m.t, 0);
  EXPECT_LT(Length(m) * HumpFactor(soil, m.slip), 0.45);
}

TEST(HumpedShear, NeverExceedsTheStrengthOnAnyPath) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> speed(-1, 1), step(1e-6, 1e-2);
  Mobilisation m{0, 0};
  for (int i = 0; i < 10000; ++i) {
    if (i % 100 == 0) m = {0, 0};
    m = Slip(m, speed(random), speed(random), step(random), kK);
    ASSERT_LE(Length(m) * HumpFactor(Humped(0.4), m.slip), 1 + 1e-12) << i;
  }
}

TEST(JanosiHanamotoShear, HasNoHump) { EXPECT_EQ(HumpFactor(kLoam, 0.1), 1.0); }

}  // namespace
}  // namespace softsoil
