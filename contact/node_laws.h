// What the nodes of any shape on soft ground have in common.
#pragma once

#include "contact/wheel_contact.h"

namespace softsoil {

// Throws std::runtime_error if the pose is not finite or more than kFarthest away.
void RequireUsable(const TirePose& pose);

// Slope of the ground along a direction, as the height lost per metre. On level ground the cosine
// of its angle to the vertical.
inline double Descent(const Eigen::Vector3d& direction_w, double slope_x, double slope_y) {
  return slope_x * direction_w.x() + slope_y * direction_w.y() - direction_w.z();
}

// Speed [m/s] at which the wheel as a whole nears the undisturbed ground. The same for all nodes: a
// node that merely rolls through the contact is not damped, or damping would resist rolling.
double ClosingSpeed(const TirePose& pose, const SurfacePoint& ground);

// Time [s] that the shear stress looks ahead at a slip of `speed` [m/s].
double ShearLead(double speed, double K);

}  // namespace softsoil
