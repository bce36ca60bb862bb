// Bearing parameters of a soil from plate-sinkage tests.
#pragma once

#include <string>
#include <vector>

#include "terrain/bearing.h"
#include "terrain/fitted.h"

namespace softsoil {

// Readings of plates pressed into the ground, by row.
struct PlateSinkage {
  std::vector<double> width;     // [m]   of the plate: diameter, or the smaller side
  std::vector<double> sinkage;   // [m]
  std::vector<double> pressure;  // [Pa]  mean below the plate
};

// Reads the columns width, sinkage and pressure of a CSV file with units. Throws InputError with
// line and rule: negative values; fewer than three rows with sinkage and pressure for a width; for
// each width, in the order of the rows, a sinkage that does not rise, or a pressure that falls by
// more than 10 % of the largest of that plate (noise may let it fall a little); a pressure without
// sinkage.
PlateSinkage ReadPlateSinkage(const std::string& file);

// What decided the two moduli. None may be below zero; k_phi may not be zero either.
enum class ModuliFrom {
  kPlates,            // two or more widths
  kNoCohesive,        // k_c (k_1) is held at zero: the data ask for less
  kNoFrictional,      // k_2 is held at zero: the data ask for less
  kPlatesOfOneWidth,  // `frictional` is k_e = k_c / b + k_phi of that width
};

struct BearingFit {
  BearingForm form;  // p = (k_c/b + k_phi) z^n or p = (k_1 + k_2 b) (z/b)^n
  ModuliFrom basis;
  Fitted cohesive;             // k_c [N/m^(n+1)] or k_1 [Pa]
  Fitted frictional;           // k_phi [N/m^(n+2)] or k_2 [Pa/m]
  Fitted exponent;             // n [-]
  double free_value;           // what the data alone ask for, where a modulus is held at zero
  std::vector<double> widths;  // [m]   rising
  std::vector<double> fitted;  // [Pa]  by row
  double rms;                  // [Pa]  residual
};

// Minimises the squares of the pressure residuals by Levenberg-Marquardt.
//
// To first order this is the classical weighted least squares of Wong (1980), ln p with the weight
// p^2, which gives the start: a load cell errs by the same pressure everywhere, and it is the high
// pressures that carry a wheel. Rows without sinkage say nothing and are left out. Throws
// InputError if the readings do not determine the parameters, if k_phi or n would not be positive,
// or if the Reece form is asked of one width.
BearingFit FitBearing(const PlateSinkage& test, BearingForm form = BearingForm::kBekker);

}  // namespace softsoil
