// A rigid wheel that rolls steadily over soft soil, driven or towed, in the plane: the soil under
// its rim is in plastic equilibrium. Wong and Reece, Journal of Terramechanics 4(1) 81-98 (driven)
// and 4(2) 7-25 (towed), 1967; Madsen (2014) section 2.3, equations 2.11 to 2.26.
//
// Angles on the rim are measured from the vertical, positive towards the front. The soil touches
// the rim from the entry angle theta_1 in front down to 0 (no rebound: theta_2 = 0), and presses
// most at theta_m between them.
//
// Slip here is i = 1 - v/(r w) of the radius r, spin w and forward speed v: 0 where the wheel rolls
// freely, 1 where it spins on the spot, negative where it skids. The skid of Wong and Reece is -i.
// Reports of softsoil give the SAE slip ratio s = (r w - v)/v (equation 4.8), hence i = s/(1 + s).
#pragma once

#include <vector>

#include "terrain/shear.h"
#include "terrain/soil.h"

namespace softsoil {

inline double SlipFromSae(double s) { return s / (1 + s); }  // s > -1
inline double SaeFromSlip(double i) { return i / (1 - i); }  // i < 1

struct RigidWheel {
  double radius;  // [m]  r, > 0
  double width;   // [m]  b, > 0
};

// Soil as the rim meets it: a plate of the wheel's width sinks by z under the pressure k_e z^n.
struct SoilUnderRim {
  double bearing_modulus;  // [N/m^(n+2)]  k_e, > 0: BearingModulus() for the wheel's width
  double n;                // [-]          sinkage exponent, > 0
  Shear shear;             //              of a towed wheel: strength > 0
  // Of a driven wheel, measured: theta_m = (c_1 + c_2 i) theta_1, equation 2.19, between 0 and
  // theta_1. A towed wheel needs none.
  MaxStress max_stress = {};
};

struct WongReece {
  double slip;               // [-]    i; of a towed wheel negative
  double entry_angle;        // [rad]  theta_1, up to 89 degrees
  double max_stress_angle;   // [rad]  theta_m; where the shear on a towed wheel changes sign
  double sinkage;            // [m]    r (1 - cos(theta_1))
  double load;               // [N]    W that the soil carries, equation 2.11
  double thrust;             // [N]    forward part of the shear forces
  double motion_resistance;  // [N]    rearward part of the normal forces
  double drawbar_pull;       // [N]    thrust - motion resistance, 2.12; < 0 if towed
  double torque;             // [N m]  that drives the wheel, equation 2.13
};

// Wheel driven at the slip i, 0 to 1. Throws InputError where a number breaks its range above, and
// where even with an entry angle of 89 degrees the soil does not carry the load [N], > 0.
WongReece DrivenWheel(const RigidWheel& wheel, const SoilUnderRim& soil, double load, double slip);

// Wheel towed without torque; finds its skid. Throws InputError as above.
WongReece TowedWheel(const RigidWheel& wheel, const SoilUnderRim& soil, double load);

struct RimStress {
  double angle;     // [rad]  theta
  double pressure;  // [Pa]   sigma, equations 2.15 to 2.17
  double shear;     // [Pa]   tau on the rim, positive where it drives the wheel forward, 2.5 or 2.8
};

// Stress on the rim of a wheel that rolls as found above; none off the contact.
RimStress StressAt(const RigidWheel& wheel, const SoilUnderRim& soil, const WongReece& rolling,
                   double angle);

// The same at n >= 2 angles, evenly spaced from 0 to the entry angle.
std::vector<RimStress> StressAlongRim(const RigidWheel& wheel, const SoilUnderRim& soil,
                                      const WongReece& rolling, int n);

}  // namespace softsoil
