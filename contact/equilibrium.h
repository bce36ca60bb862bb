// Where the pressure of the tire and the bearing capacity of the soil balance.
#pragma once

#include "contact/tire.h"
#include "terrain/plate_curve.h"
#include "terrain/soil_map.h"

namespace softsoil {

// Least cosine of the angle between the wheel radius and the ground's normal. A radius that runs
// along the ground would make the penetration infinite.
constexpr double kLeastDescent = 0.1;

// A point of the tire surface at the ground.
struct PressedPoint {
  double penetration;  // [m]  d: radial, of the undeformed tire below the surface, >= 0
  double depth;        // [m]  z_c: of the surface below where the soil begins to bear
  double release;      // [-]  loss of penetration per metre that the soil gives way, > 0
  double deepening;    // [-]  gain of depth per metre that the soil gives way, > 0
  double loose = 0;    // [m]  loose soil on top, in depth: it bears nothing
};

struct PressedState {
  double pressure;     // [Pa]  sigma
  double penetration;  // [m]   d~ that is left in the tire
  double depth;        // [m]   z~, counted as that of the point
  bool yields;         // the soil gave way beyond what springs back
};

// Solves f(d - release u) = p(z_c + deepening u) for the distance u >= 0 by which the soil gives
// way; u = 0 where the soil bears the tire as it is. Loose soil is pushed aside first. p is the
// bearing capacity k_e z^n, or below it the line on which soil reloads that springs back.
// Equations 4.5 to 4.7 and algorithm 4.1.3, with the cosine of kappa in 4.7 (the thesis prints the
// sine).
//
// The left side falls and the right side grows with u, so there is one root, and it is found to
// 1e-12 m of u or 1e-9 of the pressure.
PressedState Equilibrium(const TireSpring& spring, const PlateCurve& curve,
                         const PressedPoint& point);

// Soil under a tread: below its lugs and, where the carcass stands higher by their height, between
// them. Without lugs all of it is `below_lugs`.
struct TreadCurve {
  PlateCurve below_lugs, between_lugs;
  double height = 0;      // [m]  of the lugs
  double void_share = 0;  // [-]
};

// The width of the plate is the lesser side of what presses: of the tread without lugs, else of a
// lug, and of the gap between two.
TreadCurve CurveUnder(const Soil& soil, const TireShape& tread);

// The curves in all soils, each made when it is asked for: neighbours mostly lie in the same soil.
class TreadCurves {
 public:
  // Both must outlive the object.
  TreadCurves(const SoilMap& soils, const TireShape& tread) : soils_(soils), tread_(tread) {}

  const SoilMap& soils() const { return soils_; }
  const TreadCurve& In(int soil);  // valid until the next question

 private:
  const SoilMap& soils_;
  const TireShape& tread_;
  int soil_ = -1;  // whose curve it is
  TreadCurve curve_{};
};

// Of a tread with lugs its mean pressure and the two that it is made of.
struct TreadState : PressedState {
  double on_lugs, between_lugs;  // [Pa]
};

// The same for a tread. Its spring is that of the tread as a whole, as a test on a plate sees it:
// lugs and carcass deflect together, for the carcass can not follow single lugs. What the spring
// bears, the soil bears below the lugs and between them: f(d - release u) = (1 - v) p_l(z) +
// v p_b(z - h), z = z_c + deepening u, v the void share, h the height. On rigid ground the lugs
// bear all. `point.depth` is that of the ground at the tips of the lugs; between them it is taken
// to stand h higher, but not above the undisturbed ground.
TreadState Equilibrium(const TireSpring& spring, const TreadCurve& curve,
                       const PressedPoint& point);

// Mean pressure [Pa] that undisturbed soil bears with the tips z [m] deep.
double BearingPressure(const TreadCurve& curve, double z);

}  // namespace softsoil
