// Vertical stress in soil under a force on its surface: Froehlich for the vertical component,
// Cerruti for the horizontal one. Compression is positive.
#pragma once

#include <cmath>

#include "terrain/constants.h"
#include "terrain/host_device.h"

namespace softsoil {

// Where a point lies against a force: z [m] below it and r [m] beside it.
template <class Real>
struct Ray {
  Real inverse_R2;      // [1/m^2]  1 / (r^2 + z^2)
  Real cosine_squared;  // [-]      cos^2(theta) = (z/R)^2
};
template <class Real>
SOFTSOIL_HD inline Ray<Real> RayTo(Real r2, Real z) {
  const Real inverse_R2 = 1 / (r2 + z * z);
  return {inverse_R2, z * z * inverse_R2};
}

// Vertical stress [Pa] of a vertical force F [N], Froehlich (1934) with the concentration factor
// nu; equation 3.12. `cosine_power` is cos^nu(theta): whoever sums many pairs may pass an
// approximation of it (terrain/direct_stress.cc).
template <class Real>
SOFTSOIL_HD inline Real FroehlichStress(Real nu, Real F, Ray<Real> ray, Real cosine_power) {
  return nu / Real(2 * kPi) * F * ray.inverse_R2 * cosine_power;
}
SOFTSOIL_HD inline double CosinePower(double nu, Ray<double> ray) {
  return std::pow(ray.cosine_squared, nu / 2);
}

// Vertical stress [Pa] of a horizontal force; `moment` is r . F_H [N m], positive where the force
// points towards the soil volume. Cerruti; equation 2.35 (z^2/R^5 = cos^2(theta)/R^3).
template <class Real>
SOFTSOIL_HD inline Real CerrutiStress(Real moment, Ray<Real> ray) {
  return Real(3 / (2 * kPi)) * moment * ray.cosine_squared * ray.inverse_R2 *
         std::sqrt(ray.inverse_R2);
}

// Pairs that count: below the force and inside the cone r^2 <= (nu + 1) z^2 (algorithm 3.2.2).
template <class Real>
SOFTSOIL_HD inline bool InStressCone(Real nu, Real r2, Real z) {
  return (z > 0) & (r2 <= (nu + 1) * z * z);  // no branch: this stands in the innermost loop
}

// The most that a unit force can press anywhere below the ring of radius r, as the factor k of
// k / r^2 [1/m^2]: maxima over z of the two laws above. A bound, used to skip columns exactly.
SOFTSOIL_HD inline double FroehlichReach(double nu) {
  return nu / (2 * kPi) * std::pow(nu / 2, nu / 2) / std::pow(1 + nu / 2, 1 + nu / 2);
}
SOFTSOIL_HD inline double CerrutiReach() {
  return 3 / (2 * kPi) * (2.0 / 3) / std::pow(5.0 / 3, 2.5);
}

}  // namespace softsoil
