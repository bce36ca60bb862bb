// Pressure of the tire surface as a function of its radial penetration. Tables 6.1 to 6.3.
#pragma once

#include <cmath>

#include "terrain/host_device.h"

namespace softsoil {

// p(d) = linear d + quadratic d^2 + cubic d^3 + root sqrt(d): the five forms that the thesis tries
// are this law with some coefficients zero. None is negative and one at least is positive, so that
// the pressure rises at any penetration (6.2.1): the balance with the soil then has one solution.
struct TireSpring {
  double linear = 0;     // [Pa/m]      >= 0
  double quadratic = 0;  // [Pa/m^2]    >= 0
  double cubic = 0;      // [Pa/m^3]    >= 0
  double root = 0;       // [Pa/m^0.5]  >= 0
};

// Pressure p(d) [Pa] at the radial penetration d [m]; zero for d <= 0. Equation 4.5.
SOFTSOIL_HD inline double SpringPressure(const TireSpring& spring, double d) {
  if (d <= 0) return 0.0;
  const double polynomial = ((spring.cubic * d + spring.quadratic) * d + spring.linear) * d;
  return polynomial + spring.root * std::sqrt(d);
}

// p'(d) [Pa/m] for d > 0.
SOFTSOIL_HD inline double SpringSlope(const TireSpring& spring, double d) {
  const double polynomial = (3 * spring.cubic * d + 2 * spring.quadratic) * d + spring.linear;
  return spring.root > 0 ? polynomial + spring.root / (2 * std::sqrt(d)) : polynomial;
}

}  // namespace softsoil
