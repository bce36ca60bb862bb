#include "contact/wheel_report.h"

#include <algorithm>
#include <cmath>

#include "contact/wheel_axes.h"

namespace softsoil {
namespace {

using Eigen::Vector3d;

constexpr double kSlowest = 0.01;  // [m/s]  below it slip is not asked for its direction

// Below the tread, as far as the wheel reaches forward and back.
double DeepestSurface(const TirePose& pose, const TireShape& shape, const SurfacePatch& patch) {
  const Vector3d axis = pose.frame_w.col(1);
  double deepest = 0;
  for (int a = 0; a < patch.nodes_x(); ++a) {
    for (int b = 0; b < patch.nodes_y(); ++b) {
      const Vector3d node_w((patch.first().i + a) * patch.spacing(),
                            (patch.first().j + b) * patch.spacing(), patch.Height(a, b));
      const Vector3d from_centre = node_w - pose.centre_w;
      const double lateral = from_centre.dot(axis);
      const Vector3d along = from_centre - lateral * axis;
      const bool is_below =
          std::abs(lateral) <= shape.width / 2 && along.head<2>().norm() <= shape.radius;
      if (is_below) deepest = std::max(deepest, patch.Sinkage(a, b));
    }
  }
  return deepest;
}

}  // namespace

WheelReport ReportOf(const Tire& tire, const TirePose& pose, const PatchForces& forces) {
  const Vector3d axis = pose.frame_w.col(1);
  const WheelAxes axes = WheelAxesOf(pose, forces.patch);
  WheelReport report{};
  report.load = forces.wrench.force_w.dot(axes.up_w);
  report.rut_depth = DeepestSurface(pose, tire.shape, forces.patch);
  report.camber = std::asin(std::clamp(axis.dot(axes.up_w), -1.0, 1.0));
  report.spin = pose.angular_velocity_w.dot(axis);

  const double forward = pose.velocity_w.dot(axes.forward_w),
               left = pose.velocity_w.dot(axes.left_w);
  const double rolling = tire.shape.radius * report.spin;
  // On the spot the wheel shows which way it goes: creeping back, it is driven all the same.
  const double speed =
      std::abs(forward) >= kSlowest ? forward : std::copysign(kSlowest, forward + rolling);
  report.forward_speed = forward;
  report.slip_ratio = (rolling - forward) / speed;
  report.slip_angle =
      std::hypot(left, forward) >= kSlowest ? std::atan2(left, std::abs(forward)) : 0;

  for (const NodeContact& c : forces.contacts) {
    report.thrust += c.shear_force_w.dot(axes.forward_w);
    report.motion_resistance -= c.normal_force_w.dot(axes.forward_w);
    report.sinkage = std::max(report.sinkage, c.depth);
    report.contact_area += c.area;
    report.mean_pressure += c.pressure * c.area;
    report.peak_pressure = std::max(report.peak_pressure, c.pressure);
  }
  if (report.contact_area > 0) report.mean_pressure /= report.contact_area;
  report.drawbar_pull = report.thrust - report.motion_resistance;
  report.lateral_force = forces.wrench.force_w.dot(axes.left_w);
  report.torque = -forces.wrench.torque_w.dot(axis);
  return report;
}

}  // namespace softsoil
