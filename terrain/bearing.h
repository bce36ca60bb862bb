// Bearing capacity: the pressure that soil carries under a plate pressed into it.
#pragma once

#include <cmath>

#include "terrain/host_device.h"

namespace softsoil {

// How the bearing of a soil depends on the width b of the plate.
//   kBekker  p = (k_c/b + k_phi) z^n      Bekker (1969); Madsen (2014) equation 2.1
//   kReece   p = (k_1 + k_2 b) (z/b)^n    Reece (1965); equation 2.2 with k_1 = c k'_c and
//                                         k_2 = gamma_s k'_phi, as Wong tabulates them
enum class BearingForm { kBekker, kReece };

struct Bearing {
  double k_c;    // cohesive modulus, >= 0:    [N/m^(n+1)] Bekker, k_1 [Pa] Reece
  double k_phi;  // frictional modulus, >= 0:  [N/m^(n+2)] Bekker, k_2 [Pa/m] Reece
  double n;      // [-]  sinkage exponent, > 0
  BearingForm form = BearingForm::kBekker;
};

// Stiffness k_e [N/m^(n+2)] of soil under a plate of width b [m], so that p = k_e z^n.
SOFTSOIL_HD inline double BearingModulus(const Bearing& soil, double b) {
  if (soil.form == BearingForm::kReece) return (soil.k_c + soil.k_phi * b) / std::pow(b, soil.n);
  return soil.k_c / b + soil.k_phi;
}

// Pressure [Pa] at sinkage z [m], p = k_e z^n; zero above the ground. Equation 4.6.
SOFTSOIL_HD inline double BearingPressure(double k_e, double n, double z) {
  return z > 0 ? k_e * std::pow(z, n) : 0.0;
}

// Its derivative dp/dz [Pa/m] at the sinkage z [m] > 0 where it is p [Pa].
SOFTSOIL_HD inline double BearingSlope(double p, double n, double z) { return n * p / z; }

}  // namespace softsoil
