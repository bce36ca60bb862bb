#include "terrain/pair_stress.h"

#include <cmath>

namespace softsoil {
namespace {

// Coefficients of the monomials s^k of the interpolating Chebyshev sum.
CosineSeries FitCosinePower(double nu) {
  const double low = 1 / (nu + 2), high = 1;
  const double middle = (low + high) / 2, half_span = (high - low) / 2;
  constexpr int n = kCosineDegree + 1;
  std::array<double, n> chebyshev{};
  for (int k = 0; k < n; ++k) {
    for (int point = 0; point < n; ++point) {
      const double angle = kPi * (point + 0.5) / n;
      chebyshev[k] +=
          2.0 / n * std::pow(middle + half_span * std::cos(angle), nu / 2) * std::cos(k * angle);
    }
  }
  chebyshev[0] /= 2;
  std::array<double, n> sum{}, previous{}, current{};  // T_(k-1) and T_k as monomials
  current[0] = 1;
  for (int k = 0; k < n; ++k) {
    for (int power = 0; power < n; ++power) sum[power] += chebyshev[k] * current[power];
    std::array<double, n> next{};
    for (int power = 0; power + 1 < n; ++power) next[power + 1] = (k == 0 ? 1 : 2) * current[power];
    if (k > 0) {
      for (int power = 0; power < n; ++power) next[power] -= previous[power];
    }
    previous = current;
    current = next;
  }
  CosineSeries series{static_cast<float>(middle), static_cast<float>(1 / half_span), {}};
  for (int power = 0; power < n; ++power) {
    series.coefficient[power] = static_cast<float>(sum[power]);
  }
  return series;
}

}  // namespace

PairLaw MakePairLaw(double nu, double near_field_radius) {
  return {static_cast<float>(nu), static_cast<float>(1 / (near_field_radius * near_field_radius)),
          FitCosinePower(nu)};
}

}  // namespace softsoil
