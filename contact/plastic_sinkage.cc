#include "contact/plastic_sinkage.h"

#include <algorithm>
#include <cmath>

namespace softsoil {
namespace {

// A grid node below the tire, as the wheel sees it.
struct Below {
  double radius;    // [m]  of the unloaded tire there
  double distance;  // [m]  from the spin axis
  double height;    // [m]  over the spin axis
  double cosine;    // [-]  of kappa
};

// Of a node at `ground_w`; false where the tire does not reach it.
bool FindBelow(const TireShape& shape, const TirePose& pose, const Eigen::Vector3d& ground_w,
               Below* below) {
  const Eigen::Vector3d from_centre = ground_w - pose.centre_w;
  const Eigen::Vector3d axis = pose.frame_w.col(1);
  const double lateral = from_centre.dot(axis);
  const Eigen::Vector3d in_plane = from_centre - lateral * axis;
  if (in_plane.squaredNorm() >= shape.radius * shape.radius) return false;
  const double distance = in_plane.norm();
  const double radius = RadiusAt(shape, lateral);
  if (distance >= radius || distance <= 0) return false;
  const double cosine = -in_plane.z() / distance;
  if (cosine < kLeastDescent) return false;
  *below = {radius, distance, in_plane.z(), cosine};
  return true;
}

// How far [m] below a node the unloaded tire reaches, straight down.
double Reach(const TirePose& pose, const Below& b) {
  const double axis_z = pose.frame_w(2, 1), upright = 1 - axis_z * axis_z;
  const double out_of_tire =
      std::sqrt(b.height * b.height + upright * (b.radius * b.radius - b.distance * b.distance));
  return (b.height + out_of_tire) / upright;
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
      Below below;
      if (!FindBelow(tire.shape, pose, ground_w, &below)) continue;
      const double by_slip = patch.SlipSinkage(a, b), depth = patch.Sinkage(a, b) - by_slip;
      // As the node sinks by u the penetration falls by u cos(kappa).
      const PressedPoint point{below.radius - below.distance, depth, below.cosine, 1,
                               patch.Loose(a, b)};
      const TreadCurve& curve = curves.In(soils.NumberAt(ground_w.x(), ground_w.y()));
      const auto left = LeftBehindLug(tire, curve, point, IsBelowLug(tire.shape, pose, ground_w));
      // Where the tire rises steeply the penetration falls ever faster than by cos(kappa).
      if (left) sinkage->push_back({node, by_slip + std::min(*left, depth + Reach(pose, below))});
    }
  }
}

}  // namespace softsoil
