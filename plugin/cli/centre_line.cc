#include "plugin/cli/centre_line.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "terrain/constants.h"

namespace softsoil {
namespace {

constexpr double kSameRing = 1e-6;  // [m]  rings stand further apart
constexpr double kDegrees = 180 / kPi;

}  // namespace

void CentreLine::Add(const std::vector<softsoilContact>& contacts) {
  double nearest = std::numeric_limits<double>::infinity();  // [m]
  for (const softsoilContact& c : contacts) nearest = std::min(nearest, std::abs(c.lateral));
  for (const softsoilContact& c : contacts) {
    if (std::abs(c.lateral) > nearest + kSameRing) continue;
    const double angle = c.angle * kDegrees;
    Sum& sum = sums_[static_cast<int>(std::floor(angle))];
    sum.point.angle += angle;
    sum.point.pressure += c.pressure;
    sum.point.shear += c.shear;
    ++sum.count;
  }
}

std::vector<CentreLinePoint> CentreLine::Points() const {
  std::vector<CentreLinePoint> points;
  for (const auto& [degree, sum] : sums_) {
    const CentreLinePoint& p = sum.point;
    points.push_back({p.angle / sum.count, p.pressure / sum.count, p.shear / sum.count});
  }
  return points;
}

}  // namespace softsoil
