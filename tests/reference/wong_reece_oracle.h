// The rigid wheel of Wong and Reece (1967) once more, as the papers and Madsen (2014), 2.11 to
// 2.26, print it: integrals over the angle by Gauss' rule, unknown angles and skid by bisection.
// Shares nothing with the code that it judges.
#pragma once

namespace softsoil_reference {

// All in SI units; bearing pressure is modulus * sinkage^n.
struct SteadyWheel {
  double radius, width, modulus, n, cohesion, friction_angle, shear_modulus, load;
};

struct SteadyRolling {
  double entry_angle, max_stress_angle, sinkage, load, thrust, motion_resistance, drawbar_pull,
      torque;
  double skid;  // of a towed wheel, i = v/(r w) - 1
};

// Driven at the slip i = 1 - v/(r w), theta_m = (c_1 + c_2 i) theta_1.
SteadyRolling Driven(const SteadyWheel& wheel, double c_1, double c_2, double slip);

// Towed without torque.
SteadyRolling Towed(const SteadyWheel& wheel);

}  // namespace softsoil_reference
