#include "contact/equilibrium.h"

#include <algorithm>

namespace softsoil {

PressedState Equilibrium(const TireSpring& spring, const PlateCurve& curve,
                         const PressedPoint& point) {
  const PlaceInSoil place = PlaceAt(curve, point.depth + point.loose);
  // Neither does loose soil bear, nor ground above the undisturbed level until it is pushed down to
  // it. At `low` the tire is through, at `high` it no longer presses at all.
  const double through = std::max({0.0, point.loose, -point.depth});
  const double low = through / point.deepening, high = point.penetration / point.release;
  if (through > 0 && low >= high) return {0, 0, point.depth + point.deepening * high, high > 0};
  const double left = point.penetration - point.release * low, bare = point.depth + through;
  const double elastic = SpringPressure(spring, left);
  if (elastic <= PressureAt(place, bare).value) return {elastic, left, bare, false};

  const auto excess = [&](double u) -> ValueAndSlope {
    const double d = point.penetration - point.release * u;
    const ValueAndSlope bearing = PressureAt(place, point.depth + point.deepening * u);
    return {SpringPressure(spring, d) - bearing.value,
            -SpringSlope(spring, d) * point.release - bearing.slope * point.deepening};
  };
  const double u = FallingRoot(excess, low, high, 1e-9 * elastic);
  const double d = point.penetration - point.release * u, z = point.depth + point.deepening * u;
  return {SpringPressure(spring, d), d, z, z >= place.z_u};
}

}  // namespace softsoil
