// Pressure against sinkage of soil under a plate of one width: virgin loading, unloading and
// reloading. Madsen (2014) sections 2.2.1 and 2.2.3, after Wong (1989).
#pragma once

#include <cmath>
#include <limits>

#include "terrain/bearing.h"
#include "terrain/bracketed_newton.h"

namespace softsoil {

// Stiffness of the straight line on which soil unloads from the depth z_u [m] and reloads to it:
// k_u = k_0 + A_u z_u, equation 2.10. Infinite unless given: such soil does not spring back.
struct Unloading {
  double k_0 = std::numeric_limits<double>::infinity();  // [Pa/m]    >= 0
  double A_u = 0;                                        // [Pa/m^2]  >= 0

  SOFTSOIL_HD bool IsRigid() const { return k_0 == std::numeric_limits<double>::infinity(); }
};

struct PlateCurve {
  double k_e;  // [N/m^(n+2)]  bearing modulus under the plate
  double n;    // [-]
  Unloading unloading;
};

SOFTSOIL_HD inline PlateCurve CurveUnder(const Bearing& soil, const Unloading& unloading,
                                         double b) {
  return {BearingModulus(soil, b), soil.n, unloading};
}

// k_u [Pa/m] of unloading from the depth z_u [m] > 0.
//
// At most half of the sinkage springs back, as of the compaction of a volume (algorithm 3.2.3):
// with a small k_0 the line of 2.10 would lift the soil above its undisturbed level. And the line
// is never flatter than the virgin curve, else a greater load would leave a shallower rut.
SOFTSOIL_HD inline double UnloadingStiffness(const PlateCurve& curve, double z_u) {
  const double chord = curve.k_e * std::pow(z_u, curve.n - 1);
  const double least = (curve.n > 2 ? curve.n : 2) * chord;
  const double k_u = curve.unloading.k_0 + curve.unloading.A_u * z_u;
  return k_u > least ? k_u : least;
}

// Depth [m] that stays when the load is gone that had pressed the surface down to z_u [m]:
// equation 2.9 at p = 0.
SOFTSOIL_HD inline double ResidualDepth(const PlateCurve& curve, double z_u) {
  if (curve.unloading.IsRigid() || z_u <= 0) return z_u;
  return z_u - BearingPressure(curve.k_e, curve.n, z_u) / UnloadingStiffness(curve, z_u);
}

// The depth z_u [m] to which soil has been pressed whose surface now lies z_r [m] deep: the
// inverse of ResidualDepth(), at most 2 z_r.
SOFTSOIL_HD inline double TurningDepth(const PlateCurve& curve, double z_r) {
  if (curve.unloading.IsRigid() || z_r <= 0) return z_r;
  const auto excess = [&](double z) -> ValueAndSlope {
    const double p = BearingPressure(curve.k_e, curve.n, z), k_u = UnloadingStiffness(curve, z);
    const double stiffening = curve.unloading.A_u * p / (k_u * k_u);
    return {z_r - (z - p / k_u), -(1 - BearingSlope(p, curve.n, z) / k_u + stiffening)};
  };
  return FallingRoot(excess, z_r, 2 * z_r, 1e-12);
}

// How one place answers: it reloads on a straight line from z_r, where its surface lies, to z_u,
// and from there on it follows the virgin curve.
struct PlaceInSoil {
  PlateCurve curve;
  double z_r, z_u;  // [m]
  double k_u;       // [Pa/m]
};

SOFTSOIL_HD inline PlaceInSoil PlaceAt(const PlateCurve& curve, double z_r) {
  const double z_u = TurningDepth(curve, z_r);
  return {curve, z_r, z_u, z_u > z_r ? UnloadingStiffness(curve, z_u) : 0.0};
}

// Pressure [Pa] and its slope [Pa/m] once the surface is pressed down to the depth z [m] >= z_r.
SOFTSOIL_HD inline ValueAndSlope PressureAt(const PlaceInSoil& place, double z) {
  if (z < place.z_u) return {place.k_u * (z - place.z_r), place.k_u};
  const double p = BearingPressure(place.curve.k_e, place.curve.n, z);
  return {p, z > 0 ? BearingSlope(p, place.curve.n, z) : 0.0};
}

}  // namespace softsoil
