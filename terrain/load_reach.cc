#include "terrain/load_reach.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "terrain/point_load.h"

namespace softsoil {

LoadReach::LoadReach(const SurfaceLoad& load, double concentration_factor) : load_(load) {
  const double per_vertical = FroehlichReach(concentration_factor);
  const double per_horizontal = CerrutiReach();
  for (std::size_t k = 0; k < load.size(); ++k) {
    const NodeForce& f = load[k];
    if (footprints_.empty() || !IsNear(footprints_.back(), f)) {
      footprints_.push_back({f.source, f.x, f.x, f.y, f.y, 0, k, k});
    }
    Footprint& print = footprints_.back();
    print.last = k;
    print.x_min = std::min(print.x_min, f.x);
    print.x_max = std::max(print.x_max, f.x);
    print.y_min = std::min(print.y_min, f.y);
    print.y_max = std::max(print.y_max, f.y);
    print.reach +=
        per_vertical * std::abs(f.force_w.z()) + per_horizontal * f.force_w.head<2>().norm();
  }
}

bool LoadReach::IsNear(const Footprint& print, const NodeForce& force) {
  constexpr double kFar = 2;  // [m]  more than a wheel rolls on between two steps, by far
  return print.source == force.source && force.x >= print.x_min - kFar &&
         force.x <= print.x_max + kFar && force.y >= print.y_min - kFar &&
         force.y <= print.y_max + kFar;
}

LoadReach::Bound LoadReach::At(double x, double y) const {
  Bound bound{0, -1};
  double most = 0;
  int covering = 0;
  for (const Footprint& f : footprints_) {
    const double dx = std::max({f.x_min - x, x - f.x_max, 0.0});
    const double dy = std::max({f.y_min - y, y - f.y_max, 0.0});
    const double distance2 = dx * dx + dy * dy;
    if (distance2 <= 0) ++covering;
    const double share =
        distance2 > 0 ? f.reach / distance2 : std::numeric_limits<double>::infinity();
    if (share > most) bound.source = f.source;
    most = std::max(most, share);
    bound.stress += share;
  }
  if (covering > 1) bound.source = PressingMost(x, y);
  return bound;
}

int LoadReach::PressingMost(double x, double y) const {
  constexpr double kLeastDistance2 = 1e-4;  // [m^2]  a force right above counts, but not infinitely
  int source = -1;
  double most = 0;
  for (const Footprint& print : footprints_) {
    double press = 0;  // [N/m^2]  up to a factor
    for (std::size_t k = print.first; k <= print.last; ++k) {
      const double dx = load_[k].x - x, dy = load_[k].y - y;
      press += load_[k].force_w.norm() / (dx * dx + dy * dy + kLeastDistance2);
    }
    if (press > most) source = print.source;
    most = std::max(most, press);
  }
  return source;
}

double LoadReach::Radius(double stress) const {
  double reach = 0;
  for (const Footprint& f : footprints_) reach += f.reach;
  return std::sqrt(reach / stress);
}

}  // namespace softsoil
