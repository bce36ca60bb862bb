// Pressure of the tire surface as a function of its radial penetration. Tables 6.1 to 6.3.
#pragma once

#include <cmath>

#include "terrain/host_device.h"

namespace softsoil {

enum class SpringForm { kLinear, kSquareRoot };

struct TireSpring {
  SpringForm form;
  double coefficient;  // [Pa/m] linear, [Pa/m^0.5] square root; > 0
};

// Pressure f(d) [Pa] at the radial penetration d [m]; zero for d <= 0. Equation 4.5.
SOFTSOIL_HD inline double SpringPressure(const TireSpring& spring, double d) {
  if (d <= 0) return 0.0;
  return spring.coefficient * (spring.form == SpringForm::kLinear ? d : std::sqrt(d));
}

// f'(d) [Pa/m] for d > 0.
SOFTSOIL_HD inline double SpringSlope(const TireSpring& spring, double d) {
  return spring.form == SpringForm::kLinear ? spring.coefficient
                                            : spring.coefficient / (2 * std::sqrt(d));
}

}  // namespace softsoil
