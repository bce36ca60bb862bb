// How long a time step may be: the soil force enters MuJoCo explicitly, so a stiff tire on a light
// wheel can make the simulation blow up.
#pragma once

#include <mujoco/mujoco.h>

#include "contact/tire.h"
#include "plugin/wheel_finder.h"
#include "terrain/soil.h"

namespace softsoil {

// A mass on a spring and a damper between wheel and ground.
struct Oscillator {
  double mass;       // [kg]
  double stiffness;  // [N/m]
  double damping;    // [N s/m]
};

// Longest stable step [s] of semi-implicit Euler with an explicit spring and damper: the positive
// root of k h^2 + 2 c h - 4 m = 0; 2 sqrt(m/k) without damping.
double LongestStep(const Oscillator& oscillator);

// Estimate [s] of the longest stable step for a wheel under its static load [N]: the tire against
// the wheel's mass, and the soil's shear stiffness against its spin.
double LongestStep(const mjModel* m, const Wheel& wheel, const Tire& tire, const Soil& soil,
                   double load);

}  // namespace softsoil
