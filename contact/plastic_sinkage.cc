#include "contact/plastic_sinkage.h"

#include <cmath>

#include "contact/equilibrium.h"

namespace softsoil {
namespace {

// The tire above a grid node at `ground_w` whose surface lies `depth` [m] below the undisturbed
// ground; false where the tire does not reach it. As the node sinks by u the penetration falls by
// u cos(kappa).
bool PointBelow(const TireShape& shape, const TirePose& pose, const Eigen::Vector3d& ground_w,
                double depth, PressedPoint* point) {
  const Eigen::Vector3d from_centre = ground_w - pose.centre_w;
  const Eigen::Vector3d axis = pose.frame_w.col(1);
  const double lateral = from_centre.dot(axis);
  const Eigen::Vector3d in_plane = from_centre - lateral * axis;
  const double distance = in_plane.norm();
  const double radius = RadiusAt(shape, lateral);
  if (distance >= radius || distance <= 0) return false;
  const double cosine = -in_plane.z() / distance;
  if (cosine < kLeastDescent) return false;
  *point = {radius - distance, depth, cosine, 1.0};
  return true;
}

bool IsBelowLug(const TireShape& shape, const TirePose& pose, const Eigen::Vector3d& ground_w) {
  if (!shape.lugs) return true;
  const Eigen::Vector3d place_t = pose.frame_w.transpose() * (ground_w - pose.centre_w);
  return IsLug(shape.lugs, shape.radius, std::atan2(place_t.x(), -place_t.z()), place_t.y());
}

// Depth [m] that stays where the soil yields below the lugs or between them, 0 where it does not.
// Between them it does not before the tips are lower than the ground by the height of the lugs.
double LeftBehind(const Tire& tire, const TreadCurve& curve, PressedPoint point, bool below_lug) {
  if (!below_lug) {
    point.penetration -= point.release * curve.height / point.deepening;
    point.depth += curve.height;
    if (point.penetration <= 0) return 0;
  }
  const PressedState state = Equilibrium(tire.spring, curve, point);
  if (!state.yields) return 0;
  return below_lug ? ResidualDepth(curve.below_lugs, state.depth)
                   : ResidualDepth(curve.between_lugs, state.depth - curve.height);
}

}  // namespace

void PlasticSinkage(const Tire& tire, const TirePose& pose, const SurfacePatch& patch,
                    const Soil& soil, std::vector<NodeSinkage>* sinkage) {
  sinkage->clear();
  const TreadCurve curve = CurveUnder(soil, tire.shape);
  for (int a = 0; a < patch.nodes_x(); ++a) {
    for (int b = 0; b < patch.nodes_y(); ++b) {
      const GridNode node{patch.first().i + a, patch.first().j + b};
      const Eigen::Vector3d ground_w(node.i * patch.spacing(), node.j * patch.spacing(),
                                     patch.Height(a, b));
      PressedPoint point;
      if (!PointBelow(tire.shape, pose, ground_w, patch.Sinkage(a, b), &point)) continue;
      const double depth = LeftBehind(tire, curve, point, IsBelowLug(tire.shape, pose, ground_w));
      if (depth > 0) sinkage->push_back({node, depth});
    }
  }
}

}  // namespace softsoil
