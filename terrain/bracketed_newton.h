// Newton's method that cannot fail: steps that leave the bracket become bisections.
#pragma once

#include <cmath>

#include "terrain/host_device.h"

namespace softsoil {

struct ValueAndSlope {
  double value, slope;
};

// Root of a function that falls from `low` to `high`, found to 1e-12 of the argument or to
// `tolerance` of the value. function(x) gives ValueAndSlope.
template <class Function>
SOFTSOIL_HD double FallingRoot(const Function& function, double low, double high,
                               double tolerance) {
  double x = (low + high) / 2;
  for (int i = 0; i < 60 && high - low > 1e-12; ++i) {
    const ValueAndSlope at = function(x);
    if (std::abs(at.value) <= tolerance) break;
    (at.value > 0 ? low : high) = x;
    const double newton = x - at.value / at.slope;
    x = newton > low && newton < high ? newton : (low + high) / 2;
  }
  return x;
}

}  // namespace softsoil
