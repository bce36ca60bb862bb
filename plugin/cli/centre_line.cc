#include "plugin/cli/centre_line.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "terrain/constants.h"

namespace softsoil {
namespace {

constexpr double kSameRing = 1e-6;  // [m]  rings stand further apart

double AngleAt(int degree) { return degree + 0.5; }  // [deg]

}  // namespace

TireNodes RingsOf(const Tire& tire, double spacing) {
  return tire.mesh != nullptr ? TireNodes{} : MakeTireNodes(tire.shape, spacing);
}

CentreLine::CentreLine(const TireNodes& nodes) : middle_(std::numeric_limits<double>::infinity()) {
  const auto lateral = [&nodes](std::size_t i) { return nodes.position_t[i].y(); };
  for (std::size_t i = 0; i < nodes.size(); ++i) middle_ = std::min(middle_, std::abs(lateral(i)));
  long left = 0, right = 0;  // nodes on the ring or rings
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (std::abs(lateral(i)) > middle_ + kSameRing) continue;
    ++(lateral(i) >= 0 ? left : right);
  }
  rings_ = left > 0 && right > 0 && middle_ > kSameRing ? 2 : 1;
  pitch_ = 360.0 * rings_ / (left + right);
  if (nodes.size() == 0) middle_ = -1;  // nothing is as near to the middle plane
}

void CentreLine::Add(const std::vector<softsoilContact>& contacts) {
  ++instants_;
  for (const softsoilContact& c : contacts) {
    if (std::abs(c.lateral) > middle_ + kSameRing) continue;
    const double angle = c.angle * kDegrees;
    const int last = static_cast<int>(std::ceil(angle + pitch_));
    for (int degree = static_cast<int>(std::floor(angle - pitch_)); degree < last; ++degree) {
      const double share = 1 - std::abs(AngleAt(degree) - angle) / pitch_;
      if (share <= 0) continue;
      Sum& sum = sums_[degree];
      sum.pressure += share * c.pressure;
      sum.shear += share * c.shear;
    }
  }
}

std::vector<CentreLinePoint> CentreLine::Points() const {
  const double count = static_cast<double>(instants_) * rings_;
  std::vector<CentreLinePoint> points;
  for (const auto& [degree, sum] : sums_) {
    points.push_back({AngleAt(degree), sum.pressure / count, sum.shear / count});
  }
  return points;
}

}  // namespace softsoil
