#include "contact/equilibrium.h"

namespace softsoil {

PressedState Equilibrium(const TireSpring& spring, const PlateCurve& curve,
                         const PressedPoint& point) {
  const PlaceInSoil place = PlaceAt(curve, point.depth);
  const double elastic = SpringPressure(spring, point.penetration);
  if (elastic <= PressureAt(place, point.depth).value) {
    return {elastic, point.penetration, point.depth, false};
  }
  // At `low` the tire presses harder than the soil bears, at `high` it no longer presses at all.
  double low = 0, high = point.penetration / point.release;
  // Ground above the undisturbed level (a berm) bears nothing until it is pushed down to it.
  if (point.depth < 0) low = -point.depth / point.deepening;
  if (low >= high) return {0, 0, point.depth + point.deepening * high, true};

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
