// Surfaces with a history, made by hand.
#pragma once

#include <cmath>

#include "terrain/surface.h"

namespace softsoil {

// Sinks the nodes of |x|, |y| < half_width [m] by sinkage(x, y) [m].
template <class Sinkage>
void Press(Surface* surface, double half_width, const Sinkage& sinkage) {
  const double dx = surface->spacing();
  const int n = static_cast<int>(half_width / dx);
  for (int i = -n; i <= n; ++i) {
    for (int j = -n; j <= n; ++j) surface->DeepenPlastic({{i, j}, sinkage(i * dx, j * dx)});
  }
}

// Waves of ruts, up to 12 cm deep, with steep walls.
inline double Waves(double x, double y) {
  return 0.06 + 0.03 * std::sin(9 * x + 2 * y) + 0.03 * std::sin(14 * y - 3 * x);
}

}  // namespace softsoil
