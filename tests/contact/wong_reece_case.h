// Wheels, soils and units for the tests of the Wong-Reece wheel.
#pragma once

#include <cmath>

#include "contact/wong_reece.h"
#include "terrain/bearing.h"
#include "terrain/constants.h"

namespace softsoil {

constexpr double kInch = 0.0254;                        // [m]   exact
constexpr double kPoundForce = 4.4482216152605;         // [N]   exact
constexpr double kPsi = kPoundForce / (kInch * kInch);  // [Pa]
constexpr double kDegree = kPi / 180;                   // [rad]

// A wheel that is to carry its load on a soil.
struct LoadedWheel {
  RigidWheel wheel;
  SoilUnderRim soil;
  double load;  // [N]
};

inline WongReece DrivenAt(double slip, const LoadedWheel& c) {
  return DrivenWheel(c.wheel, c.soil, c.load, slip);
}
inline WongReece Towed(const LoadedWheel& c) { return TowedWheel(c.wheel, c.soil, c.load); }

// Modulus k_e of Reece's pressure (k_1 + k_2 b) (z/b)^n, k_1 [Pa] and k_2 [Pa/m]; equation 2.15.
inline double ReeceModulus(double k_1, double k_2, double n, double b) {
  return (k_1 + k_2 * b) / std::pow(b, n);
}

// Wong and Reece (1967): wheel of 24.7 in radius and 6 in width on compact sand, 2006 lb.
inline LoadedWheel CompactSand1967() {
  const double b = 6 * kInch, n = 0.47;
  return {{24.7 * kInch, b},
          {ReeceModulus(20 * kPsi, 2.5 * kPsi / kInch, n, b),
           n,
           {0.1 * kPsi, 33.3 * kDegree, 1.5 * kInch},
           {0.43, 0.32}},
          2006 * kPoundForce};
}

// The same wheel on loose sand; of 6 in width under 1986 lb, or of 12 in under 2085 lb.
inline LoadedWheel LooseSand1967(double width_in, double load_lb) {
  const double b = width_in * kInch, n = 1.15;
  return {{24.7 * kInch, b},
          {ReeceModulus(0, 2 * kPsi / kInch, n, b),
           n,
           {0.12 * kPsi, 31.1 * kDegree, 1.5 * kInch},
           {0.18, 0.32}},
          load_lb * kPoundForce};
}

// Azimi, Kovecses and Angeles (2013), Table III: a rover wheel on sand.
inline LoadedWheel Azimi2013() {
  const double b = 0.1, n = 0.8;
  return {
      {0.15, b}, {ReeceModulus(0, 4.1e5, n, b), n, {234, 30 * kDegree, 0.013}, {0.18, 0.32}}, 165};
}

// Madsen (2014): tractor tires as rigid wheels of the radius 0.91 m of section 6.2.1 and of their
// measured contact width b [m], on the soils of Table 6.4 with the cohesion and friction angle of
// 6.1.1 and 6.1.2. K is its printed mean plus its standard deviation: 1.06 + 0.29 and 1.06 + 0.52
// cm.
inline LoadedWheel TilledYoloLoam(double b, double load) {
  return {{0.91, b},
          {BearingModulus({6800, 1134000, 0.85}, b),
           0.85,
           {7100, 21.17 * kDegree, 0.0135},
           {0.43, 0.32}},
          load};
}
inline LoadedWheel FirmYoloLoam(double b, double load) {
  return {
      {0.91, b},
      {BearingModulus({66000, 4486000, 1}, b), 1, {35720, 23.13 * kDegree, 0.0158}, {0.18, 0.32}},
      load};
}

}  // namespace softsoil
