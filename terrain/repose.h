// How steep soil stands: a heap of loose soil, and a wall cut into firm soil.
#pragma once

#include <cmath>
#include <limits>

#include "terrain/constants.h"
#include "terrain/host_device.h"
#include "terrain/shear.h"

namespace softsoil {

// Greatest height [m] of a slope of the angle beta [rad] cut into soil of unit weight gamma
// [N/m^3]: 4 c/gamma sin(beta) cos(phi) / (1 - cos(beta - phi)); any height up to beta = phi. A
// vertical cut stands 4 c/gamma tan(45 deg + phi/2) high. Culmann (1875), plane failure; Terzaghi
// (1943).
SOFTSOIL_HD inline double CriticalHeight(const Shear& soil, double gamma, double beta) {
  const double phi = soil.friction_angle;
  if (beta <= phi) return std::numeric_limits<double>::infinity();
  return 4 * soil.cohesion / gamma * std::sin(beta) * std::cos(phi) / (1 - std::cos(beta - phi));
}

// Steepest angle [rad] at which a heap of `height` [m] can stand: the friction angle and the share
// that cohesion adds.
SOFTSOIL_HD inline double SteepestHeap(const Shear& soil, double gamma, double height) {
  double stands = soil.friction_angle, falls = kPi / 2;
  if (CriticalHeight(soil, gamma, falls) >= height) return falls;
  for (int k = 0; k < 50; ++k) {
    const double middle = (stands + falls) / 2;
    (CriticalHeight(soil, gamma, middle) >= height ? stands : falls) = middle;
  }
  return stands;
}

}  // namespace softsoil
