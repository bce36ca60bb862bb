#include "contact/equilibrium.h"

#include <gtest/gtest.h>

#include <random>

namespace softsoil {
namespace {

struct Case {
  TireSpring spring;
  double k_e, n;
  PressedPoint point;

  PressedState Solve() const { return Equilibrium(spring, PlateCurve{k_e, n, {}}, point); }

  // The two sides of the balance once the soil has given way by u [m].
  double TirePressure(double u) const {
    const double d = std::max(0.0, point.penetration - point.release * u);
    return spring.linear * d + spring.quadratic * d * d + spring.cubic * d * d * d +
           spring.root * std::sqrt(d);
  }
  double SoilPressure(double u) const {
    const double z = point.depth + point.deepening * u;
    return z > 0 ? k_e * std::pow(z, n) : 0.0;
  }
};

// Any spring, soil and point, extremes included.
class Cases {
 public:
  Case Next() {
    Case c{Spring(), Power(3, 9), Uniform(0.1, 2), {}};
    c.point = {Power(-9, -0.3), Uniform(-0.2, 1), Uniform(0.05, 1), Uniform(0.05, 1)};
    if (Uniform(0, 1) < 0.3) c.point.depth = 0;
    if (Uniform(0, 1) < 0.3) c.point.depth = Power(-9, -1);
    if (Uniform(0, 1) < 0.02) c.point.penetration = 0;
    return c;
  }

 private:
  // Of each of the five forms, or of all terms at once.
  TireSpring Spring() {
    switch (std::uniform_int_distribution<int>(0, 5)(random_)) {
      case 0: return {Power(4, 8), 0, 0, 0};
      case 1: return {Power(4, 8), Power(5, 9), 0, 0};
      case 2: return {Power(4, 8), Power(5, 9), Power(6, 10), 0};
      case 3: return {Power(4, 8), 0, 0, Power(4, 8)};
      case 4: return {0, 0, 0, Power(4, 8)};
      default: return {Power(4, 8), Power(5, 9), Power(6, 10), Power(4, 8)};
    }
  }
  double Uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  double Power(double low, double high) { return std::pow(10.0, Uniform(low, high)); }
  std::mt19937 random_{1};
};

constexpr int kCases = 100000;

// The excess of tire over soil falls with u, so its sign around the answer encloses the root.
TEST(Equilibrium, GivesWayJustUntilTireAndSoilBalance) {
  Cases cases;
  int yielded = 0;
  for (int i = 0; i < kCases; ++i) {
    const Case c = cases.Next();
    const PressedState state = c.Solve();
    if (!state.yields || state.pressure == 0) continue;
    ++yielded;
    const double u = (state.depth - c.point.depth) / c.point.deepening;
    const double step = 2e-12 + 1e-15 / c.point.deepening;
    const double tolerance = 2e-9 * c.TirePressure(0);
    ASSERT_GE(c.TirePressure(u - step) - c.SoilPressure(u - step), -tolerance) << i;
    ASSERT_LE(c.TirePressure(u + step) - c.SoilPressure(u + step), tolerance) << i;
  }
  EXPECT_GT(yielded, kCases / 4);
}

TEST(Equilibrium, KeepsTirePressureAndPenetrationTogether) {
  Cases cases;
  for (int i = 0; i < kCases; ++i) {
    const Case c = cases.Next();
    const PressedState state = c.Solve();
    ASSERT_DOUBLE_EQ(state.pressure, SpringPressure(c.spring, state.penetration)) << i;
    const double u = (state.depth - c.point.depth) / c.point.deepening;
    ASSERT_NEAR(state.penetration, c.point.penetration - c.point.release * u, 1e-13) << i;
  }
}

TEST(Equilibrium, NeitherPressesHarderThanTheTireNorLiftsTheSoil) {
  Cases cases;
  for (int i = 0; i < kCases; ++i) {
    const Case c = cases.Next();
    const PressedState state = c.Solve();
    ASSERT_TRUE(std::isfinite(state.pressure) && std::isfinite(state.depth)) << i;
    ASSERT_GE(state.pressure, 0) << i;
    ASSERT_LE(state.pressure, c.TirePressure(0) * (1 + 1e-12)) << i;
    ASSERT_GE(state.penetration, 0) << i;
    ASSERT_LE(state.penetration, c.point.penetration) << i;
    ASSERT_GE(state.depth, c.point.depth) << i;
  }
}

TEST(Equilibrium, LeavesSoilThatBearsTheTireAsItIs) {
  Cases cases;
  int elastic = 0;
  for (int i = 0; i < kCases; ++i) {
    const Case c = cases.Next();
    const PressedState state = c.Solve();
    ASSERT_EQ(state.yields, c.TirePressure(0) > c.SoilPressure(0)) << i;
    if (state.yields) continue;
    ++elastic;
    ASSERT_EQ(state.depth, c.point.depth);
    ASSERT_EQ(state.penetration, c.point.penetration);
  }
  EXPECT_GT(elastic, kCases / 4);
}

// A linear tire of stiffness a on soil with n = 1 is two springs in series.
TEST(Equilibrium, IsTwoSpringsInSeriesOnALinearSoil) {
  const double a = 2e6, k_e = 1e6;
  const Case c{{a, 0, 0, 0}, k_e, 1, {0.06, 0, 1, 1}};
  EXPECT_NEAR(c.Solve().pressure, 0.06 / (1 / a + 1 / k_e), 1e-3);
  EXPECT_NEAR(c.Solve().depth, 0.04, 1e-9);
  EXPECT_NEAR(c.Solve().penetration, 0.02, 1e-9);
}

// 2 cm of loose soil in a rut 5 cm deep: the tire meets the floor of the rut.
TEST(Equilibrium, PushesLooseSoilAsideBeforeTheFirmSoilBears) {
  const Case bare{{2e6, 0, 0, 0}, 1e6, 1, {0.06, 0.05, 1, 1}};
  const Case filled{{2e6, 0, 0, 0}, 1e6, 1, {0.08, 0.03, 1, 1, 0.02}};
  EXPECT_NEAR(filled.Solve().depth, bare.Solve().depth, 1e-9);
  EXPECT_NEAR(filled.Solve().pressure / bare.Solve().pressure, 1, 1e-6);
  const Case light{{2e6, 0, 0, 0}, 1e6, 1, {0.04, 0.03, 1, 1, 0.02}};
  EXPECT_NEAR(light.Solve().depth, 0.05, 1e-12);
  EXPECT_NEAR(light.Solve().penetration, 0.02, 1e-12);
  EXPECT_FALSE(light.Solve().yields);
}

TEST(Equilibrium, PushesABermDownBeforeItBears) {
  const Case c{{2e6, 0, 0, 0}, 1e6, 1, {0.08, -0.02, 1, 1}};
  EXPECT_NEAR(c.Solve().depth, 0.04, 1e-9);  // the case above, after 2 cm of berm
  const Case high{{2e6, 0, 0, 0}, 1e6, 1, {0.015, -0.02, 1, 1}};
  EXPECT_EQ(high.Solve().pressure, 0);
  EXPECT_NEAR(high.Solve().depth, -0.005, 1e-12);
}

TEST(Equilibrium, SinksLessIntoStrongerSoil) {
  double last = 1;
  for (double k_e = 1e3; k_e < 1e9; k_e *= 2) {
    const Case c{{0, 0, 0, 3.469e5}, k_e, 0.85, {0.1, 0, 0.9, 1}};
    EXPECT_LT(c.Solve().depth, last) << k_e;
    last = c.Solve().depth;
  }
}

}  // namespace
}  // namespace softsoil
