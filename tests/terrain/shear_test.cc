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

TEST(Slip, IsKeptAtRest) {
  const Mobilisation m = Slip({0.3, -0.4}, 0, 0, 1, kK);
  EXPECT_EQ(m.t, 0.3);
  EXPECT_EQ(m.b, -0.4);
}

}  // namespace
}  // namespace softsoil
