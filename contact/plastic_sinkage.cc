#include "contact/plastic_sinkage.h"

#include <algorithm>
#include <cmath>

namespace softsoil {
namespace {

// The tire above a grid node.
struct Above {
  PressedPoint point;
  double lowest;  // [m]  of the unloaded tire there, below the undisturbed ground
};

// At a node at `ground_w` whose surface lies `depth` [m] below the undisturbed ground; false where
// the tire does not reach it. As the node sinks by u the penetration falls by u cos(kappa).
bool FindAbove(const TireShape& shape, const TirePose& pose, const Eigen::Vector3d& ground_w,
               double depth, Above* above) {
  const Eigen::Vector3d from_centre = ground_w - pose.centre_w;
  const Eigen::Vector3d axis = pose.frame_w.col(1);
  const double lateral = from_centre.dot(axis);
  const Eigen::Vector3d in_plane = from_centre - lateral * axis;
  const double distance = in_plane.norm();
  const double radius = RadiusAt(shape, lateral);
  if (distance >= radius || distance <= 0) return false;
  const double cosine = -in_plane.z() / distance;
  if (cosine < kLeastDescent) return false;
  above->point = {radius - distance, depth, cosine, 1.0};
  const double upright = 1 - axis.z() * axis.z();
  const double out_of_tire =
      std::sqrt(in_plane.z() * in_plane.z() + upright * (radius * radius - distance * distance));
  above->lowest = depth + (in_plane.z() + out_of_tire) / upright;
  return true;
}

bool IsBelowLug(const TireShape& shape, const TirePose& pose, const Eigen::Vector3d& ground_w) {
  if (!shape.lugs) return true;
  const Eigen::Vector3d place_t = pose.frame_w.transpose() * (ground_w - pose.centre_w);
  return IsLug(shape.lugs, shape.radius, std::atan2(place_t.x(), -place_t.z()), place_t.y());
}

// Below a lug, or between two: there the soil does not give way before the tips are lower than the
// ground by the height of the lugs.
std::optional<double> LeftBehindLug(const Tire& tire, const TreadCurve& curve, PressedPoint point,
                                    bool below_lug) {
  const double raised = below_lug ? 0 : curve.height;  // [m]  what presses, above the tips
  point.penetration -= point.release * raised / point.deepening;
  if (point.penetration <= 0) return std::nullopt;
  point.depth += raised;
  PressedState state = Equilibrium(tire.spring, curve, point);
  state.depth -= raised;
  point.depth -= raised;
  return LeftBehind(below_lug ? curve.below_lugs : curve.between_lugs, state, point);
}

}  // namespace

std::optional<double> LeftBehind(const PlateCurve& curve, const PressedState& state,
                                 const PressedPoint& point) {
  if (!state.yields && point.loose <= 0) return std::nullopt;
  // Loose soil does not spring back.
  const double through = std::min(state.depth, point.depth + point.loose);
  return state.yields ? std::max(ResidualDepth(curve, state.depth), through) : through;
}

void PlasticSinkage(const Tire& tire, const TirePose& pose, const SurfacePatch& patch,
                    const SoilMap& soils, std::vector<NodeSinkage>* sinkage) {
  sinkage->clear();
  TreadCurves curves(soils, tire.shape);
  for (int a = 0; a < patch.nodes_x(); ++a) {
    for (int b = 0; b < patch.nodes_y(); ++b) {
      const GridNode node{patch.first().i + a, patch.first().j + b};
      const Eigen::Vector3d ground_w(node.i * patch.spacing(), node.j * patch.spacing(),
                                     patch.Height(a, b));
      Above above;
      const double by_slip = patch.SlipSinkage(a, b), depth = patch.Sinkage(a, b) - by_slip;
      if (!FindAbove(tire.shape, pose, ground_w, depth, &above)) continue;
      above.point.loose = patch.Loose(a, b);
      const TreadCurve& curve = curves.In(soils.NumberAt(ground_w.x(), ground_w.y()));
      const auto left =
          LeftBehindLug(tire, curve, above.point, IsBelowLug(tire.shape, pose, ground_w));
      // Where the tire rises steeply the penetration falls ever faster than by cos(kappa).
      if (left) sinkage->push_back({node, by_slip + std::min(*left, above.lowest)});
    }
  }
}

}  // namespace softsoil
