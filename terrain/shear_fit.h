// Shear strength of a soil from shear tests: annulus, shear box or plate at given normal stresses.
#pragma once

#include <string>
#include <vector>

#include "terrain/fitted.h"

namespace softsoil {

// Readings by row.
struct ShearTest {
  std::vector<double> normal_stress;  // [Pa]  nominal, one value for each test
  std::vector<double> displacement;   // [m]   slip
  std::vector<double> shear_stress;   // [Pa]
};

// Reads the columns normal_stress, displacement and shear_stress of a CSV file with units. Throws
// InputError with line and rule: negative values; fewer than three rows for a normal stress; a
// displacement that does not rise, in the order of the rows, at one normal stress.
ShearTest ReadShearTest(const std::string& file);

// What the bounds c >= 0 and phi >= 0 decided in place of the data.
enum class StrengthBound { kNone, kNoCohesion, kNoFriction };

struct ShearFit {
  Fitted cohesion;        // [Pa]
  Fitted friction_angle;  // [rad]
  Fitted modulus;         // [m]  K
  StrengthBound bound;
  double free_value;      // [Pa] or [rad]  what the data alone ask for, where a bound decided
  bool is_short;          // the slip ends before 2 K: the strength is extrapolated
  bool falls_after_peak;  // by more than 10 %: the law, which levels off, misses that
  std::vector<double> normal_stresses;  // [Pa]  rising
  std::vector<double> fitted;           // [Pa]  by row
  double rms;                           // [Pa]  residual
};

// Least squares of tau = (c + sigma tan(phi)) (1 - exp(-j/K)), Mohr-Coulomb and Janosi-Hanamoto
// (1961); equation 4.15 of Madsen (2014) as it should read. Throws InputError if the readings do
// not determine the parameters; one normal stress never does.
ShearFit FitShear(const ShearTest& test);

}  // namespace softsoil
