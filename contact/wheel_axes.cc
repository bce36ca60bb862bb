#include "contact/wheel_axes.h"

namespace softsoil {
namespace {

using Eigen::Vector3d;

constexpr double kLeastSine = 1e-9;  // [-]  between spin axis and ground normal

Vector3d GroundNormal(const TirePose& pose, const SurfacePatch& patch) {
  if (patch.nodes_x() == 0) return Vector3d::UnitZ();  // nothing was evaluated yet
  const SurfacePoint ground = patch.At(pose.centre_w.x(), pose.centre_w.y());
  return Vector3d(-ground.undisturbed_x, -ground.undisturbed_y, 1).normalized();
}

}  // namespace

WheelAxes WheelAxesOf(const TirePose& pose, const SurfacePatch& patch) {
  const Vector3d up = GroundNormal(pose, patch);
  const Vector3d ahead = pose.frame_w.col(1).cross(up);
  const double length = ahead.norm();
  const Vector3d forward = length > kLeastSine ? Vector3d(ahead / length) : up.unitOrthogonal();
  return {forward, up.cross(forward), up};
}

}  // namespace softsoil
