#include "contact/tire_nodes.h"

#include <algorithm>
#include <cmath>

#include "terrain/constants.h"

namespace softsoil {
namespace {

// One ring of nodes: where its cross-section stands and how wide it is.
struct Ring {
  double radius, lateral;                // [m]
  double normal_radial, normal_lateral;  // [-]
  double arc;                            // [m]  length across the tread
};

std::vector<Ring> Rings(const TireShape& shape, double spacing) {
  std::vector<Ring> rings;
  const bool cylinder = std::isinf(shape.crown_radius);
  const double half_angle = cylinder ? 0 : std::asin(shape.width / (2 * shape.crown_radius));
  const double arc = cylinder ? shape.width : 2 * shape.crown_radius * half_angle;
  const int count = std::max(1, static_cast<int>(std::lround(arc / spacing)));
  for (int k = 0; k < count; ++k) {
    const double place = (2 * k + 1.0) / count - 1;  // in (-1, 1)
    if (cylinder) {
      rings.push_back({shape.radius, place * shape.width / 2, 1, 0, arc / count});
    } else {
      const double beta = place * half_angle;
      rings.push_back({shape.radius - shape.crown_radius * (1 - std::cos(beta)),
                       shape.crown_radius * std::sin(beta), std::cos(beta), std::sin(beta),
                       arc / count});
    }
  }
  return rings;
}

}  // namespace

TireNodes MakeTireNodes(const TireShape& shape, double spacing) {
  TireNodes nodes;
  const int around = std::max(24, static_cast<int>(std::lround(2 * kPi * shape.radius / spacing)));
  const Eigen::Vector3d axis = Eigen::Vector3d::UnitY();
  const std::vector<Ring> rings = Rings(shape, spacing);
  for (int k = 0; k < around; ++k) {
    const double theta = 2 * kPi * k / around;
    const Eigen::Vector3d radial(std::sin(theta), 0, -std::cos(theta));
    const Eigen::Vector3d tangent(std::cos(theta), 0, std::sin(theta));
    for (const Ring& ring : rings) {
      nodes.position_t.push_back(ring.radius * radial + ring.lateral * axis);
      nodes.radial_t.push_back(radial);
      nodes.normal_t.push_back(ring.normal_radial * radial + ring.normal_lateral * axis);
      nodes.tangent_t.push_back(tangent);
      nodes.binormal_t.push_back(nodes.normal_t.back().cross(tangent));
      nodes.radius.push_back(ring.radius);
      nodes.area.push_back(ring.arc * ring.radius * 2 * kPi / around);
    }
  }
  return nodes;
}

double RadiusAt(const TireShape& shape, double y) {
  if (std::abs(y) > shape.width / 2) return 0;
  if (std::isinf(shape.crown_radius)) return shape.radius;
  const double r = shape.crown_radius;
  return shape.radius - r + std::sqrt(r * r - y * y);
}

}  // namespace softsoil
