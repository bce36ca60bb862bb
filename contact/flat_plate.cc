#include "contact/flat_plate.h"

#include <algorithm>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>

#include "contact/tire_nodes.h"
#include "terrain/constants.h"

namespace softsoil {
namespace {

constexpr double kTolerance = 1e-10;  // relative, of an integral

template <class Function>
double Integral(const Function& f, double from, double to) {
  constexpr unsigned kMostHalvings = 15;
  return boost::math::quadrature::gauss_kronrod<double, 15>::integrate(f, from, to, kMostHalvings,
                                                                       kTolerance);
}

// Integral of f over half the width of the contact, f a function of how far the tire at y reaches
// below the plate. At the end of an ellipse f may fall like a root, which y = y_0 sin(t) makes
// smooth.
template <class Function>
double OverTheHalfWidth(const TireShape& shape, double z, const Function& f) {
  const double half = shape.width / 2, crown = shape.crown_radius;
  if (std::isinf(crown)) return half * f(z);
  const double y_0 = z < crown ? FlatPlateWidth(crown, z) / 2 : crown;
  const double last = half < y_0 ? std::asin(half / y_0) : kPi / 2;
  const auto at = [&](double t) {
    const double y = y_0 * std::sin(t);
    const double drop = y * y / (crown + std::sqrt(crown * crown - y * y));
    return f(std::max(0.0, z - drop)) * y_0 * std::cos(t);
  };
  return Integral(at, 0, last);
}

// Integral of p(a + reach - a / cos(theta)) over the angles of contact. theta = theta_max sin(s)
// makes it smooth also where the pressure begins like a root; nothing cancels for a small reach.
double OverTheAngle(const TireSpring& spring, double reach, double a) {
  if (reach <= 0) return 0;
  const double last = 2 * std::asin(std::sqrt(reach / (2 * (a + reach))));
  const auto at = [&](double s) {
    const double theta = last * std::sin(s), half_sine = std::sin(theta / 2);
    const double d = reach - a * 2 * half_sine * half_sine / std::cos(theta);
    return SpringPressure(spring, d) * last * std::cos(s);
  };
  return Integral(at, 0, kPi / 2);
}

}  // namespace

double FlatPlateLoad(const Tire& tire, double z, double node_spacing) {
  const TireNodes nodes = MakeTireNodes(tire.shape, node_spacing);
  const double plate = z - tire.shape.radius;  // height, from the wheel centre
  double load = 0;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const double below = plate - nodes.position_t[i].z();
    const double cosine = -nodes.radial_t[i].z();
    if (below <= 0 || cosine <= 0) continue;
    const double d = std::min(below / cosine, nodes.radius[i]);
    load += SpringPressure(tire.spring, d) * LoadedArea(nodes.area[i], nodes.radius[i], d) *
            -nodes.normal_t[i].z();
  }
  return load;
}

double FlatPlateLoad(const TireShape& shape, const TireSpring& spring, double z) {
  if (z <= 0) return 0;
  const double a = shape.radius - z;
  const auto at = [&](double reach) { return OverTheAngle(spring, reach, a); };
  return 4 * a * OverTheHalfWidth(shape, z, at);
}

double FlatPlateArea(const TireShape& shape, double z) {
  if (z <= 0) return 0;
  const double a = shape.radius - z;
  const auto half_length = [a](double reach) { return std::sqrt(reach * (2 * a + reach)); };
  return 4 * OverTheHalfWidth(shape, z, half_length);
}

double FlatPlateWidth(double crown_radius, double z) {
  return 2 * std::sqrt(std::max(0.0, z * (2 * crown_radius - z)));
}

}  // namespace softsoil
