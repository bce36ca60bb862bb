#include "terrain/point_load.h"

#include <gtest/gtest.h>

#include <functional>

#include "tests/reference/point_load_oracle.h"

namespace softsoil {
namespace {

constexpr double kConcentrations[] = {3, 4, 4.5, 5, 6};

double Froehlich(double nu, double F, double r, double z) {
  const Ray<double> ray = RayTo(r * r, z);
  return FroehlichStress(nu, F, ray, CosinePower(nu, ray));
}

// Integral over r from 0 to `end` [m] by Simpson's rule.
double Integral(double end, const std::function<double(double)>& f) {
  constexpr int n = 20000;
  double sum = f(0) + f(end);
  for (int i = 1; i < n; ++i) sum += (i % 2 == 0 ? 2 : 4) * f(end * i / n);
  return sum * end / n / 3;
}

TEST(Froehlich, CarriesTheWholeLoadThroughEveryPlane) {
  for (double nu : kConcentrations) {
    for (double z : {0.1, 0.3, 1.0}) {
      const double load =
          Integral(400 * z, [&](double r) { return 2 * kPi * r * Froehlich(nu, 18e3, r, z); });
      const double beyond = 18e3 * std::pow(400, -nu);
      EXPECT_NEAR(load + beyond, 18e3, 18e3 * 1e-6) << "nu " << nu << " z " << z;
    }
  }
}

TEST(Froehlich, CarriesAKnownShareInsideTheStressCone) {
  for (double nu : kConcentrations) {
    const double z = 0.3;
    const double inside = Integral(std::sqrt(nu + 1) * z,
                                   [&](double r) { return 2 * kPi * r * Froehlich(nu, 1, r, z); });
    EXPECT_NEAR(inside, softsoil_reference::ShareInsideCone(nu), 1e-9) << nu;
    EXPECT_GT(inside, 0.91) << nu;
  }
}

TEST(Froehlich, UnderACircleIsTheClosedForm) {
  const double p = 100e3, a = 0.2;
  for (double nu : kConcentrations) {
    for (double z : {0.05, 0.2, 0.6}) {
      const double stress =
          Integral(a, [&](double r) { return Froehlich(nu, p * 2 * kPi * r, r, z); });
      EXPECT_NEAR(stress, softsoil_reference::StressUnderCircle(p, nu, a, z), p * 1e-9)
          << "nu " << nu << " z " << z;
    }
  }
}

// Boussinesq (1885): 3 F z^3 / (2 pi R^5).
TEST(Froehlich, WithThreeIsTheElasticHalfSpace) {
  EXPECT_NEAR(Froehlich(3, 10, 3, 4), 3 * 10 * 64 / (2 * kPi * 3125), 1e-12);
}

TEST(Cerruti, SumsToZeroOverEveryPlane) {
  const double F = 5e3, z = 0.3, dx = 0.01;
  double sum = 0, pressing = 0;
  for (int i = -500; i <= 500; ++i) {
    for (int j = -500; j <= 500; ++j) {
      const double x = i * dx, y = j * dx;
      const double force = CerrutiStress(F * x, RayTo(x * x + y * y, z)) * dx * dx;
      sum += force;
      pressing += std::max(force, 0.0);
    }
  }
  EXPECT_GT(pressing, 0.2 * F);
  EXPECT_NEAR(sum, 0, 1e-9 * F);
}

TEST(Cerruti, PressesAheadOfTheForceAndLiftsBehindIt) {
  const double F = 5e3, r = 0.3, z = 0.3;
  const double ahead = CerrutiStress(F * r, RayTo(r * r, z));
  EXPECT_GT(ahead, 0);
  EXPECT_EQ(CerrutiStress(-F * r, RayTo(r * r, z)), -ahead);
}

TEST(StressCone, HoldsWhatIsBelowAndNotTooFarBeside) {
  EXPECT_TRUE(InStressCone(5.0, 0.0, 0.1));
  EXPECT_TRUE(InStressCone(5.0, 5.999, 1.0));
  EXPECT_FALSE(InStressCone(5.0, 6.001, 1.0));
  EXPECT_FALSE(InStressCone(5.0, 0.0, 0.0));
  EXPECT_FALSE(InStressCone(5.0, 0.0, -0.1));
}

// The bound is reached in some depth, or columns would be visited for nothing.
TEST(Reach, IsTheMostThatAForcePressesInAnyDepth) {
  for (double nu : kConcentrations) {
    const double r = 0.4;
    double froehlich = 0, cerruti = 0;
    for (double z = 0.001; z < 4; z += 0.001) {
      froehlich = std::max(froehlich, Froehlich(nu, 1, r, z));
      cerruti = std::max(cerruti, CerrutiStress(r, RayTo(r * r, z)));
    }
    EXPECT_LE(froehlich, FroehlichReach(nu) / (r * r) * (1 + 1e-12));
    EXPECT_GT(froehlich, FroehlichReach(nu) / (r * r) * (1 - 1e-4));
    EXPECT_LE(cerruti, CerrutiReach() / (r * r) * (1 + 1e-12));
    EXPECT_GT(cerruti, CerrutiReach() / (r * r) * (1 - 1e-4));
  }
}

}  // namespace
}  // namespace softsoil
