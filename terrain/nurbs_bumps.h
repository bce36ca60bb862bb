// Bumpy ground without end, the same on every machine: a NURBS surface over a grid of control
// points, as section 6.3.3 of the thesis drives on.
#pragma once

#include <cstdint>

#include "terrain/limits.h"
#include "terrain/surface.h"

namespace softsoil {

constexpr Limits kBumpHeightLimits = {0.0001, 10};   // [m]
constexpr Limits kBumpSpacingLimits = {0.01, 1000};  // [m]
constexpr Limits kBumpSeedLimits = {0, 999999};      // [-]
constexpr double kSteepestBumps = 0.5;               // [-]  height / spacing, at most

struct NurbsBumps {
  double height = 0;       // [m]  of the highest and lowest control points, >= 0; 0: level
  double spacing = 1;      // [m]  of the control points, > 0
  std::uint32_t seed = 0;  // other bumps for every seed
};

// Height [m] of the bumps at finite x, y [m]:
//   sum N_i(x/s) N_j(y/s) w_ij z_ij / sum N_i(x/s) N_j(y/s) w_ij
// with the uniform cubic B-splines N (Piegl and Tiller, The NURBS Book, 1997), control heights z
// evenly spread from -height to height and weights w evenly spread from 0.5 to 2, both from a hash
// of i, j and the seed. Twice continuously differentiable, never beyond +-height, zero on average;
// the root of the mean square is 0.29 height. Beyond 2^53 spacings it stays as there. Only +, -, *,
// / and floor: the same bits everywhere.
double HeightOf(const NurbsBumps& bumps, double x, double y);

// The ground with bumps on it, added along z: on a slope, too, the height stays a function of x, y.
UndisturbedHeight WithBumps(UndisturbedHeight ground, const NurbsBumps& bumps);

}  // namespace softsoil
