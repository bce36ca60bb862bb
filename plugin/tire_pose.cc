#include "plugin/tire_pose.h"

#include <Eigen/Geometry>

#include "plugin/model_geometry.h"

namespace softsoil {

using Eigen::Matrix3d;
using Eigen::Vector3d;

Matrix3d TireFrame(const Vector3d& spin_axis) {
  Matrix3d frame;
  frame.col(1) = spin_axis.normalized();
  frame.col(0) = spin_axis.unitOrthogonal();
  frame.col(2) = frame.col(0).cross(frame.col(1));
  return frame;
}

// mjData gives the velocity of a body as that of the point of it that is at the centre of mass of
// its kinematic tree.
TirePose PoseOf(const mjModel* m, const mjData* d, const Wheel& wheel,
                const Matrix3d& tire_frame_b) {
  const int body = wheel.body;
  using RowMajor = Eigen::Matrix<mjtNum, 3, 3, Eigen::RowMajor>;
  const Matrix3d body_w = Eigen::Map<const RowMajor>(d->xmat + 9 * body);
  TirePose pose;
  pose.centre_w = Vector(d->xpos + 3 * body) + body_w * wheel.centre_b;
  pose.frame_w = body_w * tire_frame_b;
  pose.angular_velocity_w = Vector(d->cvel + 6 * body);
  const Vector3d reference_w = Vector(d->subtree_com + 3 * m->body_rootid[body]);
  pose.velocity_w =
      Vector(d->cvel + 6 * body + 3) + pose.angular_velocity_w.cross(pose.centre_w - reference_w);
  return pose;
}

}  // namespace softsoil
