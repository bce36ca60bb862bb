#include "contact/equilibrium.h"

#include <cmath>

namespace softsoil {

PressedState Equilibrium(const TireSpring& spring, double k_e, double n,
                         const PressedPoint& point) {
  const double elastic = SpringPressure(spring, point.penetration);
  if (elastic <= BearingPressure(k_e, n, point.depth)) {
    return {elastic, point.penetration, point.depth, false};
  }
  // At `low` the tire presses harder than the soil bears, at `high` it no longer presses at all.
  double low = 0, high = point.penetration / point.release;
  // Ground above the undisturbed level (a berm) bears nothing until it is pushed down to it.
  if (point.depth < 0) low = -point.depth / point.deepening;
  if (low >= high) return {0, 0, point.depth + point.deepening * high, true};

  double u = (low + high) / 2;
  for (int i = 0; i < 60 && high - low > 1e-12; ++i) {
    const double d = point.penetration - point.release * u;
    const double z = point.depth + point.deepening * u;
    const double bearing = BearingPressure(k_e, n, z);
    const double excess = SpringPressure(spring, d) - bearing;
    if (std::abs(excess) <= 1e-9 * elastic) break;
    (excess > 0 ? low : high) = u;
    const double slope =
        -SpringSlope(spring, d) * point.release - BearingSlope(bearing, n, z) * point.deepening;
    const double newton = u - excess / slope;
    u = newton > low && newton < high ? newton : (low + high) / 2;
  }
  const double d = point.penetration - point.release * u;
  return {SpringPressure(spring, d), d, point.depth + point.deepening * u, true};
}

}  // namespace softsoil
