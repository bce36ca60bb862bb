// Passive earth pressure: what soil bears before a wall that is pushed into it fails along a plane
// at 45 - phi/2 degrees. Madsen (2014) section 2.6.1, after Bekker (1956).
#pragma once

#include <cmath>

#include "terrain/constants.h"
#include "terrain/host_device.h"
#include "terrain/shear.h"

namespace softsoil {

// N_phi = tan^2(45 deg + phi/2) [-] of the friction angle phi [rad].
SOFTSOIL_HD inline double FlowValue(double friction_angle) {
  const double tangent = std::tan(kPi / 4 + friction_angle / 2);
  return tangent * tangent;
}

// What the passive pressure of a soil depends on; worked out once where many points are asked
// about.
struct PassiveStrength {
  SOFTSOIL_HD PassiveStrength(const Shear& soil)
      : cohesion(soil.cohesion), n_phi(FlowValue(soil.friction_angle)), root(std::sqrt(n_phi)) {}

  double cohesion;     // [Pa]
  double n_phi, root;  // [-]  flow value, and its square root
};

// Passive pressure [Pa] at the depth z [m] below the free surface of soil of unit weight gamma
// [N/m^3], on a vertical, smooth wall and without surcharge:
// sigma_p = gamma z N_phi + 2 c sqrt(N_phi), equation 2.74. None above the surface.
SOFTSOIL_HD inline double PassivePressure(const PassiveStrength& soil, double gamma, double z) {
  if (z <= 0) return 0.0;
  return gamma * z * soil.n_phi + 2 * soil.cohesion * soil.root;
}

// Its sum [N/m] over a wall of the height Z [m], per metre of its length; equation 2.75.
SOFTSOIL_HD inline double PassiveForce(const PassiveStrength& soil, double gamma, double Z) {
  if (Z <= 0) return 0.0;
  return gamma * soil.n_phi * Z * Z / 2 + 2 * soil.cohesion * Z * soil.root;
}

}  // namespace softsoil
