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

// One row of nodes across the tread.
struct Row {
  double theta;     // [rad]  at the middle of the tread, ahead of the lowest point
  double per_turn;  // [-]    how many of its width go around the tire
  bool on_lug;
};

std::vector<Row> SmoothRows(double radius, double spacing) {
  const int around = std::max(24, static_cast<int>(std::lround(2 * kPi * radius / spacing)));
  std::vector<Row> rows;
  for (int k = 0; k < around; ++k) {
    rows.push_back({2 * kPi * k / around, static_cast<double>(around), true});
  }
  return rows;
}

// Every lug and every gap has the same number of rows, at least one.
std::vector<Row> LuggedRows(const Lugs& lugs, double radius, double spacing) {
  std::vector<Row> rows;
  const double pitch = 2 * kPi / lugs.count;  // [rad]
  for (int k = 0; k < lugs.count; ++k) {
    double from = k * pitch;
    for (const bool on_lug : {true, false}) {
      const double width = pitch * (on_lug ? 1 - lugs.void_share : lugs.void_share);
      const int count = std::max(1, static_cast<int>(std::lround(width * radius / spacing)));
      for (int i = 0; i < count; ++i) {
        rows.push_back({from + (i + 0.5) * width / count, count * 2 * kPi / width, on_lug});
      }
      from += width;
    }
  }
  return rows;
}

}  // namespace

TireNodes MakeTireNodes(const TireShape& shape, double spacing) {
  TireNodes nodes;
  nodes.shape = shape;
  const Eigen::Vector3d axis = Eigen::Vector3d::UnitY();
  const std::vector<Ring> rings = Rings(shape, spacing);
  nodes.rings = static_cast<int>(rings.size());
  for (const Row& row : shape.lugs ? LuggedRows(shape.lugs, shape.radius, spacing)
                                   : SmoothRows(shape.radius, spacing)) {
    for (const Ring& ring : rings) {
      const double lead = shape.lugs ? LugLead(shape.lugs, shape.radius, ring.lateral) : 0;
      const double theta = row.theta + lead;
      const Eigen::Vector3d radial(std::sin(theta), 0, -std::cos(theta));
      const Eigen::Vector3d tangent(std::cos(theta), 0, std::sin(theta));
      nodes.position_t.push_back(ring.radius * radial + ring.lateral * axis);
      nodes.radial_t.push_back(radial);
      nodes.normal_t.push_back(ring.normal_radial * radial + ring.normal_lateral * axis);
      nodes.tangent_t.push_back(tangent);
      nodes.binormal_t.push_back(nodes.normal_t.back().cross(tangent));
      nodes.radius.push_back(ring.radius);
      nodes.area.push_back(ring.arc * ring.radius * 2 * kPi / row.per_turn);
      nodes.length.push_back(ring.radius * 2 * kPi / row.per_turn);
      if (shape.lugs) nodes.on_lug.push_back(row.on_lug);
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
