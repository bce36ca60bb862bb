#include "contact/wong_reece.h"

#include <algorithm>
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <cstdint>
#include <string>

#include "terrain/constants.h"
#include "terrain/input_error.h"

namespace softsoil {
namespace {

// Steeper, and the wheel would be sunk to its axle.
constexpr double kSteepestEntry = 89 / kDegrees;
constexpr int kEntries = 89;         // steps in which the entry angle is looked for
constexpr double kLoadError = 1e-6;  // [-]

void CheckPositive(const std::string& name, const std::string& unit, double value) {
  if (value > 0 && std::isfinite(value)) return;
  throw InputError(name + " must be > 0" + unit + " and finite, got " + Shown(value));
}

void Check(const RigidWheel& wheel, const SoilUnderRim& soil, double load) {
  CheckPositive("radius", " m", wheel.radius);
  CheckPositive("width", " m", wheel.width);
  CheckPositive("bearing modulus", " N/m^(n+2)", soil.bearing_modulus);
  CheckPositive("n", "", soil.n);
  CheckPositive("k_e r^n", " Pa", soil.bearing_modulus * std::pow(wheel.radius, soil.n));
  CheckPositive("shear modulus", " m", soil.shear.modulus);
  CheckPositive("load", " N", load);
  const double c = soil.shear.cohesion, phi = soil.shear.friction_angle;
  if (!(c >= 0 && std::isfinite(c))) throw InputError("cohesion must be >= 0 Pa, got " + Shown(c));
  if (!(phi >= 0 && phi < kPi / 2)) {
    throw InputError("friction angle must be 0 to below 90 deg, got " + Shown(phi * kDegrees));
  }
}

// The contact of a rim with soil, once its angles and its slip are known.
struct Rim {
  RigidWheel wheel;
  SoilUnderRim soil;
  double entry_angle, max_stress_angle, slip;
};

// Angle [rad] at a share of the way from an end of the contact, 0, to the greatest pressure, 1.
double FrontAngle(const Rim& rim, double share) {
  return rim.entry_angle - share * (rim.entry_angle - rim.max_stress_angle);
}
double RearAngle(const Rim& rim, double share) { return share * rim.max_stress_angle; }

// Pressure [Pa] at that share, in front and in the rear alike: k_e r^n (cos theta - cos theta_1)^n
// with the theta in front, equations 2.15 to 2.17. The difference is written as a product because
// it would lose its digits near the entry.
double Pressure(const Rim& rim, double share) {
  const double half = share * (rim.entry_angle - rim.max_stress_angle) / 2;
  const double depth = 2 * rim.wheel.radius * std::sin(rim.entry_angle - half) * std::sin(half);
  return rim.soil.bearing_modulus * std::pow(depth, rim.soil.n);
}

// Shear displacement [m] of the rim on soil since the angle `from`, backwards positive, where the
// soil moves with the wheel's axle only: equations 2.18 and, with i the negative skid, 2.26.
double Displacement(const Rim& rim, double from, double angle) {
  return rim.wheel.radius * (from - angle - (1 - rim.slip) * (std::sin(from) - std::sin(angle)));
}

// The same in front of theta_0 under a towed wheel, where soil is pushed ahead. Equation 2.25.
double BulldozedDisplacement(const Rim& rim, double angle) {
  const double theta_1 = rim.entry_angle, theta_0 = rim.max_stress_angle;
  const double chord = (std::sin(theta_1) - std::sin(theta_0)) / (theta_1 - theta_0);
  return rim.wheel.radius * (1 - rim.slip) *
         ((theta_1 - angle) * chord - (std::sin(theta_1) - std::sin(angle)));
}

double ShearDisplacement(const Rim& rim, double angle) {
  const bool towed = rim.slip < 0;
  if (towed && angle > rim.max_stress_angle) return BulldozedDisplacement(rim, angle);
  return Displacement(rim, towed ? rim.max_stress_angle : rim.entry_angle, angle);
}

// Shear against the displacement: Janosi and Hanamoto, equation 2.5, or with a hump, 2.8.
RimStress Stress(const Rim& rim, double share, double angle) {
  const Shear& shear = rim.soil.shear;
  const double pressure = Pressure(rim, share), j = ShearDisplacement(rim, angle);
  const double strength = shear.cohesion + pressure * std::tan(shear.friction_angle);
  const double mobilised =
      -std::expm1(-std::abs(j) / shear.modulus) * HumpFactor(shear, std::abs(j));
  return {angle, pressure, std::copysign(strength * mobilised, j)};
}

// Integral of density(stress) [Pa] over the contact area, in N. Both zones run from an end of the
// contact, where the n-th power has its singularity, to the greatest pressure. The tanh-sinh rule
// is at ease with any singularity at an end, and with the thin layer in which shear builds up.
template <class Density>
double OverContact(const Rim& rim, const Density& density) {
  // Smooth stress needs about six halvings of its step; the kink of a hump would take any number.
  thread_local boost::math::quadrature::tanh_sinh<double> rule(9);  // holds a table of its nodes
  const double rear = rim.max_stress_angle, front = rim.entry_angle - rear;
  const auto both_zones = [&](double share) {
    return front * density(Stress(rim, share, FrontAngle(rim, share))) +
           rear * density(Stress(rim, share, RearAngle(rim, share)));
  };
  return rim.wheel.radius * rim.wheel.width * rule.integrate(both_zones, 0.0, 1.0, 1e-10);
}

double LoadOn(const Rim& rim) {
  return OverContact(rim, [](const RimStress& s) {
    return s.pressure * std::cos(s.angle) + s.shear * std::sin(s.angle);
  });
}

double TorqueOf(const Rim& rim) {
  return rim.wheel.radius * OverContact(rim, [](const RimStress& s) { return s.shear; });
}

WongReece Performance(const Rim& rim) {
  const double thrust =
      OverContact(rim, [](const RimStress& s) { return s.shear * std::cos(s.angle); });
  const double resistance =
      OverContact(rim, [](const RimStress& s) { return s.pressure * std::sin(s.angle); });
  const double half = std::sin(rim.entry_angle / 2);
  return {rim.slip,     rim.entry_angle, rim.max_stress_angle, 2 * rim.wheel.radius * half * half,
          LoadOn(rim),  thrust,          resistance,           thrust - resistance,
          TorqueOf(rim)};
}

// Zero of f between a and b, where its values f_a and f_b have different signs.
template <class Function>
double Root(const Function& f, double a, double b, double f_a, double f_b) {
  const boost::math::tools::eps_tolerance<double> close(50);  // bits
  std::uintmax_t iterations = 500;
  const auto [low, high] = boost::math::tools::toms748_solve(f, a, b, f_a, f_b, close, iterations);
  return low + (high - low) / 2;
}

// Throws InputError unless the rim carries the load: what jumps has no root.
Rim Carrying(double load, const Rim& rim) {
  const double carried = LoadOn(rim);
  if (std::abs(carried - load) <= kLoadError * load) return rim;
  throw InputError("load must be one that an entry angle carries; at " +
                   Shown(rim.entry_angle * kDegrees) + " deg it jumps past " + Shown(load) + " N");
}

// The rim among rim_at(entry angle) that carries the load, of the least sinkage: the load need not
// rise all the way to the steepest entry, nor every entry have a rim.
template <class RimAt>
Rim RimUnder(double load, const RimAt& rim_at) {
  const auto excess = [&](double entry_angle) { return LoadOn(rim_at(entry_angle)) - load; };
  double low = 0, lacking = -load, most = 0, steepest = 0;
  std::string refusal;  // of the last entry without a rim
  for (int k = 1; k <= kEntries; ++k) {
    const double high = k == kEntries ? kSteepestEntry : k * kSteepestEntry / kEntries;
    double carried = 0;
    try {
      carried = LoadOn(rim_at(high));
    } catch (const InputError& error) {
      refusal = error.what();
      continue;
    }
    if (carried > load) {
      return Carrying(load, rim_at(Root(excess, low, high, lacking, carried - load)));
    }
    low = high;
    lacking = carried - load;
    if (carried > most) most = carried, steepest = high;
  }
  if (most == 0) throw InputError(refusal);
  throw InputError("load must be < " + Shown(most) +
                   " N, which the soil carries at an entry angle of " +
                   Shown(std::round(steepest * kDegrees)) + " deg, got " + Shown(load));
}

double MaxStressRatio(const MaxStress& place, double slip) {
  const double ratio = place.c_1 + place.c_2 * slip;
  if (ratio > 0 && ratio < 1) return ratio;
  throw InputError("theta_m / theta_1 = c_1 + c_2 i must be > 0 and < 1, got " + Shown(ratio) +
                   " at the slip i = " + Shown(slip));
}

// Angle [rad] between the rim's normal and the direction in which soil fails.
double FailureAngle(const Shear& shear) { return kPi / 4 - shear.friction_angle / 2; }

// The rim of a wheel towed with such a skid that the soil parts at theta_0: equation 2.20, solved
// for 1 + skid = cos(alpha) / cos(theta_0 + alpha) with the failure angle alpha.
Rim TowedRim(const RigidWheel& wheel, const SoilUnderRim& soil, double theta_1, double theta_0) {
  const double alpha = FailureAngle(soil.shear);
  return {wheel, soil, theta_1, theta_0, 1 - std::cos(alpha) / std::cos(theta_0 + alpha)};
}

// The towed rim without torque, of the least skid. With theta_0 near 0 shear drives the wheel all
// along the rim. With theta_0 at the entry, or where the wheel is locked, theta_0 + alpha = pi/2,
// it brakes; but of soil whose shear strength is gone after a hump little may be left there.
Rim TorqueFreeRim(const RigidWheel& wheel, const SoilUnderRim& soil, double theta_1) {
  const auto torque = [&](double theta_0) {
    return TorqueOf(TowedRim(wheel, soil, theta_1, theta_0));
  };
  constexpr int kParts = 16;
  const double part = std::min(theta_1, kPi / 2 - FailureAngle(soil.shear)) / kParts;
  double low = 1e-9 * part, driving = torque(low);
  for (int k = 1; k <= kParts; ++k) {
    const double high = (k - 1e-9) * part, torque_there = torque(high);
    if (torque_there <= 0 && driving > 0) {
      return TowedRim(wheel, soil, theta_1, Root(torque, low, high, driving, torque_there));
    }
    low = high;
    driving = torque_there;
  }
  throw InputError(
      "a towed wheel must have some skid without torque, got none at the entry angle " +
      Shown(theta_1 * kDegrees) + " deg; the load is too small, or the soil loses its strength");
}

}  // namespace

WongReece DrivenWheel(const RigidWheel& wheel, const SoilUnderRim& soil, double load, double slip) {
  Check(wheel, soil, load);
  if (!(slip >= 0 && slip <= 1)) throw InputError("slip must be 0 to 1, got " + Shown(slip));
  const double ratio = MaxStressRatio(soil.max_stress, slip);
  return Performance(RimUnder(load, [&](double entry_angle) {
    return Rim{wheel, soil, entry_angle, ratio * entry_angle, slip};
  }));
}

WongReece TowedWheel(const RigidWheel& wheel, const SoilUnderRim& soil, double load) {
  Check(wheel, soil, load);
  if (soil.shear.cohesion == 0 && soil.shear.friction_angle == 0) {
    throw InputError(
        "a wheel can be towed without torque at any skid on soil without strength; "
        "cohesion or friction angle must be > 0, got 0");
  }
  return Performance(
      RimUnder(load, [&](double entry_angle) { return TorqueFreeRim(wheel, soil, entry_angle); }));
}

RimStress StressAt(const RigidWheel& wheel, const SoilUnderRim& soil, const WongReece& rolling,
                   double angle) {
  const double theta_1 = rolling.entry_angle, theta_m = rolling.max_stress_angle;
  if (angle < 0 || angle > theta_1) return {angle, 0, 0};
  const double share = angle < theta_m ? angle / theta_m : (theta_1 - angle) / (theta_1 - theta_m);
  return Stress({wheel, soil, theta_1, theta_m, rolling.slip}, share, angle);
}

std::vector<RimStress> StressAlongRim(const RigidWheel& wheel, const SoilUnderRim& soil,
                                      const WongReece& rolling, int n) {
  std::vector<RimStress> stresses;
  for (int k = 0; k < n; ++k) {
    const double angle = k + 1 == n ? rolling.entry_angle : k * rolling.entry_angle / (n - 1);
    stresses.push_back(StressAt(wheel, soil, rolling, angle));
  }
  return stresses;
}

}  // namespace softsoil
