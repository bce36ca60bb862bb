#include "contact/flank.h"

#include <cmath>

#include "contact/tread_rows.h"
#include "terrain/earth_pressure.h"

namespace softsoil {
namespace {

using Eigen::Vector3d;

constexpr double kLeastShare = 1e-9;  // [-]  a mobilisation below it is rounding

// Share [-] of the pressure that is mobilised, positive by slip to the left.
double Leftward(const std::vector<NodeContact>& contacts, const TreadRow& row) {
  const auto at = [&](int i) { return -contacts[i].mobilised.b; };  // the binormal is to the right
  if (row.left < 0) return row.right < 0 ? 0 : at(row.right);
  if (row.right < 0) return at(row.left);
  return (at(row.right) + at(row.left)) / 2;
}

// To the left along the ground.
Vector3d Left(const TirePose& pose) {
  const Vector3d axis = pose.frame_w.col(1);
  return Vector3d(axis.x(), axis.y(), 0).stableNormalized();
}

// On the wheel, at a contact.
void AddForce(int i, const Vector3d& force_w, const TirePose& pose, PatchForces* forces) {
  NodeContact& contact = forces->contacts[i];
  contact.flank_force_w = force_w;
  forces->surface[i].force_w -= force_w;
  forces->wrench.force_w += force_w;
  forces->wrench.torque_w += (contact.point_w - pose.centre_w).cross(force_w);
}

}  // namespace

void PushFlanks(const TireNodes& nodes, const TirePose& pose, const SoilMap& soils,
                PatchForces* forces) {
  const Vector3d left_w = Left(pose);
  const double spacing = forces->patch.spacing();
  ForEachRow(forces->contacts, nodes.rings, [&](const TreadRow& row) {
    const double share = Leftward(forces->contacts, row);
    const int edge = share > 0 ? row.left : row.right;
    if (std::abs(share) < kLeastShare || edge < 0) return;
    const NodeContact& contact = forces->contacts[edge];
    const double to_the_edge = nodes.shape.width / 2 - std::abs(nodes.position_t[contact.node].y());
    const Vector3d beyond_w =
        contact.point_w + std::copysign(to_the_edge + spacing, share) * left_w;
    const double height = forces->patch.At(beyond_w.x(), beyond_w.y()).height - contact.point_w.z();
    const Soil& soil = soils.At(beyond_w.x(), beyond_w.y());
    const double passive =
        nodes.length[contact.node] * PassiveForce(soil.shear, UnitWeight(soil), height);
    AddForce(edge, -share * passive * left_w, pose, forces);
  });
}

}  // namespace softsoil
