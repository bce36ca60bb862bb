#include "contact/patch_report.h"

#include <cmath>

#include "contact/wheel_axes.h"

namespace softsoil {
namespace {

using Eigen::Vector3d;

// Stress [Pa] of a force [N] on an area [m^2]. A node that is pressed to the axle has none.
double Stress(double force, double area) { return area > 0 ? force / area : 0; }

}  // namespace

std::vector<PatchPoint> PatchReportOf(const TireNodes& nodes, const TirePose& pose,
                                      const PatchForces& forces) {
  const Vector3d axis_w = pose.frame_w.col(1);
  const Vector3d forward_w = WheelAxesOf(pose, forces.patch).forward_w;
  const Vector3d down_w = axis_w.cross(forward_w);  // in the plane of the wheel
  std::vector<PatchPoint> points;
  points.reserve(forces.contacts.size());
  for (const NodeContact& c : forces.contacts) {
    const Vector3d radial_w = pose.frame_w * nodes.radial_t[c.node];
    const Vector3d tangent_w = pose.frame_w * nodes.tangent_t[c.node];    // forward at the lowest
    const Vector3d to_right_w = pose.frame_w * nodes.binormal_t[c.node];  // across the tread
    PatchPoint point;
    point.position_w = c.point_w;
    point.normal_force_w = c.normal_force_w;
    point.shear_force_w = c.shear_force_w;
    point.flank_force_w = c.flank_force_w;
    point.angle = std::atan2(radial_w.dot(forward_w), radial_w.dot(down_w));
    point.lateral = (c.point_w - pose.centre_w).dot(axis_w);
    point.pressure = c.pressure;
    point.shear = Stress(c.shear_force_w.dot(tangent_w), c.area);
    point.shear_across = -Stress(c.shear_force_w.dot(to_right_w), c.area);
    point.area = c.area;
    point.depth = c.depth;
    points.push_back(point);
  }
  return points;
}

}  // namespace softsoil
