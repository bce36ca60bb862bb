#include "contact/equilibrium.h"

#include <algorithm>
#include <cmath>

namespace softsoil {
namespace {

// Mean over a tread, and what it is made of.
struct LuggedPressure : ValueAndSlope {
  double below_lugs, between_lugs;  // [Pa]
};

// The soil below the lugs and, higher by the height of these, between them.
struct LuggedPlace {
  LuggedPlace(const TreadCurve& curve, double depth)
      : below_lugs(PlaceAt(curve.below_lugs, depth)),
        between_lugs(PlaceAt(curve.between_lugs, std::max(0.0, depth - curve.height))),
        height(curve.height),
        void_share(curve.void_share),
        z_u(below_lugs.z_u) {}

  PlaceInSoil below_lugs, between_lugs;
  double height, void_share, z_u;
};

// Once the lug tips are pressed down to z.
LuggedPressure PressureAt(const LuggedPlace& place, double z) {
  const bool touches = z - place.height >= place.between_lugs.z_r;
  const ValueAndSlope lug = PressureAt(place.below_lugs, z),
                      gap = touches ? PressureAt(place.between_lugs, z - place.height)
                                    : ValueAndSlope{0, 0};
  const double v = place.void_share;
  return {{(1 - v) * lug.value + v * gap.value, (1 - v) * lug.slope + v * gap.slope},
          lug.value,
          gap.value};
}

// `bearing` is what the soil bears in the balance.
template <class Place, class Pressure>
PressedState Balance(const TireSpring& spring, const Place& place, const PressedPoint& point,
                     Pressure* bearing) {
  // Neither does loose soil bear, nor ground above the undisturbed level until it is pushed down to
  // it. At `low` the tire is through, at `high` it no longer presses at all.
  const double through = std::max({0.0, point.loose, -point.depth});
  const double low = through / point.deepening, high = point.penetration / point.release;
  if (through > 0 && low >= high) return {0, 0, point.depth + point.deepening * high, high > 0};
  const double left = point.penetration - point.release * low, bare = point.depth + through;
  const double elastic = SpringPressure(spring, left);
  *bearing = PressureAt(place, bare);
  if (elastic <= bearing->value) return {elastic, left, bare, false};

  const auto excess = [&](double u) -> ValueAndSlope {
    const double d = point.penetration - point.release * u;
    *bearing = PressureAt(place, point.depth + point.deepening * u);
    return {SpringPressure(spring, d) - bearing->value,
            -SpringSlope(spring, d) * point.release - bearing->slope * point.deepening};
  };
  const double u = FallingRoot(excess, low, high, 1e-9 * elastic);
  const double d = point.penetration - point.release * u, z = point.depth + point.deepening * u;
  return {SpringPressure(spring, d), d, z, z >= place.z_u};
}

}  // namespace

PressedState Equilibrium(const TireSpring& spring, const PlateCurve& curve,
                         const PressedPoint& point) {
  ValueAndSlope bearing{};
  return Balance(spring, PlaceAt(curve, point.depth + point.loose), point, &bearing);
}

TreadCurve CurveUnder(const Soil& soil, const TireShape& tread) {
  const auto under = [&](double width) {
    return CurveUnder(soil.bearing, soil.unloading, std::min(width, tread.width));
  };
  const Lugs& lugs = tread.lugs;
  if (!lugs) return {under(tread.width), {}};
  return {under(LugWidth(lugs, tread.radius)),
          under(LugGap(lugs, tread.radius) * std::cos(lugs.angle)), lugs.height, lugs.void_share};
}

const TreadCurve& TreadCurves::In(int soil) {
  if (soil != soil_) curve_ = CurveUnder(soils_[soil], tread_);
  soil_ = soil;
  return curve_;
}

TreadState Equilibrium(const TireSpring& spring, const TreadCurve& curve,
                       const PressedPoint& point) {
  if (curve.height == 0) {
    const PressedState state = Equilibrium(spring, curve.below_lugs, point);
    return {state, state.pressure, state.pressure};
  }
  const LuggedPlace place(curve, point.depth + point.loose);
  LuggedPressure bearing{};
  TreadState state{Balance(spring, place, point, &bearing), 0, 0};
  // Where it bears more than it must, all of it gives back alike.
  const double share = bearing.value > 0 ? state.pressure / bearing.value : 0;
  state.between_lugs = share * bearing.between_lugs;
  state.on_lugs = (state.pressure - curve.void_share * state.between_lugs) / (1 - curve.void_share);
  return state;
}

double BearingPressure(const TreadCurve& curve, double z) {
  const auto bears = [](const PlateCurve& plate, double depth) {
    return BearingPressure(plate.k_e, plate.n, depth);
  };
  if (curve.height == 0) return bears(curve.below_lugs, z);
  return (1 - curve.void_share) * bears(curve.below_lugs, z) +
         curve.void_share * bears(curve.between_lugs, z - curve.height);
}

}  // namespace softsoil
