// Bearing capacity: the pressure that soil carries under a plate pressed into it.
#pragma once

#include <cmath>

#include "terrain/host_device.h"

namespace softsoil {

struct Bearing {
  double k_c;    // [N/m^(n+1)]  cohesive modulus, >= 0
  double k_phi;  // [N/m^(n+2)]  frictional modulus, > 0
  double n;      // [-]          sinkage exponent, > 0
};

// Stiffness k_e = k_c/b + k_phi [N/m^(n+2)] of soil under a plate of width b [m].
// Bekker (1969); Madsen (2014) equation 2.1.
SOFTSOIL_HD inline double BearingModulus(const Bearing& soil, double b) {
  return soil.k_c / b + soil.k_phi;
}

// Pressure [Pa] at sinkage z [m], p = k_e z^n; zero above the ground. Equation 4.6.
SOFTSOIL_HD inline double BearingPressure(double k_e, double n, double z) {
  return z > 0 ? k_e * std::pow(z, n) : 0.0;
}

// Its derivative dp/dz [Pa/m] at the sinkage z [m] > 0 where it is p [Pa].
SOFTSOIL_HD inline double BearingSlope(double p, double n, double z) { return n * p / z; }

}  // namespace softsoil
