#include "terrain/gaussian_law.h"

#include <gtest/gtest.h>

#include <cmath>

#include "terrain/point_load.h"

namespace softsoil {
namespace {

constexpr double kFactors[] = {3, 3.4, 4, 4.7, 5, 6};
constexpr float kDepths[] = {1.0f, 1.1f, 1.19f, 1.3f, 3.7f, 30.0f, 1000.0f};

double Vertical(const GaussianSum& sum, double r) {
  double stress = 0;
  for (int k = 0; k < kGaussians; ++k) {
    stress += sum.vertical[k] * std::exp(-r * r / std::exp2(0.5 * (sum.first + k)));
  }
  return stress;
}

double Horizontal(const GaussianSum& sum, double r) {
  double stress = 0;
  for (int k = 0; k < kGaussians; ++k) {
    stress += r * sum.horizontal[k] * std::exp(-r * r / std::exp2(0.5 * (sum.first + k)));
  }
  return stress;
}

// Off the edge of the cone, where the laws jump: there sums of Gaussians go through the middle.
template <class Check>
void ForEachPoint(const Check& check) {
  for (const double nu : kFactors) {
    const GaussianLaw law(nu);
    for (const float depth : kDepths) {
      for (double r = 0; r < 8 * depth; r += 0.05 * depth) {
        const bool is_at_edge = std::abs(r / depth - std::sqrt(nu + 1)) < 0.4;
        if (!is_at_edge) check(law.At(depth), nu, depth, r);
      }
    }
  }
}

TEST(GaussianLaw, IsCloseToFroehlichsLawInTheCone) {
  ForEachPoint([](const GaussianSum& sum, double nu, double z, double r) {
    const auto ray = RayTo<double>(r * r, z);
    const double expected =
        InStressCone(nu, r * r, z) ? FroehlichStress(nu, 1.0, ray, CosinePower(nu, ray)) : 0.0;
    const double most = nu / (2 * kPi) / (z * z);
    EXPECT_NEAR(Vertical(sum, r), expected, 0.01 * most) << nu << " at " << z << ", " << r;
  });
}

TEST(GaussianLaw, IsCloseToCerrutisLawInTheCone) {
  ForEachPoint([](const GaussianSum& sum, double nu, double z, double r) {
    const double expected = InStressCone(nu, r * r, z) ? CerrutiStress(r, RayTo(r * r, z)) : 0.0;
    const double most = CerrutiStress(z / 2, RayTo(z * z / 4, z));
    EXPECT_NEAR(Horizontal(sum, r), expected, 0.03 * most) << nu << " at " << z << ", " << r;
  });
}

TEST(GaussianLaw, CarriesTheLoadThroughEveryPlane) {
  for (const double nu : kFactors) {
    const GaussianLaw law(nu);
    const double in_cone = 1 - std::pow(nu + 2, -nu / 2);
    for (const float depth : kDepths) {
      const GaussianSum sum = law.At(depth);
      double load = 0;
      for (int k = 0; k < kGaussians; ++k) {
        load += kPi * sum.vertical[k] * std::exp2(0.5 * (sum.first + k));
      }
      EXPECT_NEAR(load, in_cone, 1e-3) << nu << " at " << depth;
    }
  }
}

}  // namespace
}  // namespace softsoil
