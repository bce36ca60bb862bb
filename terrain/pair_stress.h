// The laws of terrain/point_load.h in float, as the innermost loops of the stress field need them.
#pragma once

#include <array>

#include "terrain/point_load.h"

namespace softsoil {

// cos^nu(theta) = t^(nu/2), t = z^2 / R^2, as a polynomial in t, for real nu without a power per
// pair. Inside the cone t >= 1/(nu + 2), where the function is smooth: Chebyshev interpolation of
// this degree is good to float accuracy.
constexpr int kCosineDegree = 7;
struct CosineSeries {
  float middle, scale;                               // s = (t - middle) * scale, in [-1, 1]
  std::array<float, kCosineDegree + 1> coefficient;  // of s^k
};

struct PairLaw {
  float nu;             // [-]
  float inverse_near2;  // [1/m^2]  1 / R_min^2
  CosineSeries cosine;
};
PairLaw MakePairLaw(double nu, double near_field_radius);

// Horner's rule from the highest power down to k, unrolled, for the loop around it is the one to
// become SIMD.
template <int k = 0>
inline float Horner(const CosineSeries& series, float s) {
  if constexpr (k == kCosineDegree) {
    return series.coefficient[k];
  } else {
    return Horner<k + 1>(series, s) * s + series.coefficient[k];
  }
}

// Stress [Pa] of a force: `vertical` [N] downwards, `moment` [N m] of its horizontal part r . F_H.
// No branch: this stands in the innermost loop.
inline float PairStress(const PairLaw& law, float vertical, float moment, const Ray<float>& ray) {
  const float s = (ray.cosine_squared - law.cosine.middle) * law.cosine.scale;
  return FroehlichStress(law.nu, vertical, ray, Horner(law.cosine, s)) + CerrutiStress(moment, ray);
}

inline bool InNearField(const PairLaw& law, const Ray<float>& ray, float depth) {
  return (depth > 0) & (ray.inverse_R2 > law.inverse_near2);
}

}  // namespace softsoil
