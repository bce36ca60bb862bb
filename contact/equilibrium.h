// Where the pressure of the tire and the bearing capacity of the soil balance.
#pragma once

#include "contact/tire_spring.h"
#include "terrain/plate_curve.h"

namespace softsoil {

// Least cosine of the angle between the wheel radius and the ground's normal. A radius that runs
// along the ground would make the penetration infinite.
constexpr double kLeastDescent = 0.1;

// A point of the tire surface at the ground.
struct PressedPoint {
  double penetration;  // [m]  d: radial, of the undeformed tire below the surface, >= 0
  double depth;        // [m]  z_c: of the surface below where the soil begins to bear
  double release;      // [-]  loss of penetration per metre that the soil gives way, > 0
  double deepening;    // [-]  gain of depth per metre that the soil gives way, > 0
  double loose = 0;    // [m]  loose soil on top, in depth: it bears nothing
};

struct PressedState {
  double pressure;     // [Pa]  sigma
  double penetration;  // [m]   d~ that is left in the tire
  double depth;        // [m]   z~ of the surface below the undisturbed ground
  bool yields;         // the soil gave way beyond what springs back
};

// Solves f(d - release u) = p(z_c + deepening u) for the distance u >= 0 by which the soil gives
// way; u = 0 where the soil bears the tire as it is. Loose soil is pushed aside first. p is the
// bearing capacity k_e z^n, or below it the line on which soil reloads that springs back.
// Equations 4.5 to 4.7 and algorithm 4.1.3, with the cosine of kappa in 4.7 (the thesis prints the
// sine).
//
// The left side falls and the right side grows with u, so there is one root, and it is found to
// 1e-12 m of u or 1e-9 of the pressure.
PressedState Equilibrium(const TireSpring& spring, const PlateCurve& curve,
                         const PressedPoint& point);

}  // namespace softsoil
