#include "contact/node_laws.h"

#include <stdexcept>

#include "terrain/input_error.h"

namespace softsoil {

void RequireUsable(const TirePose& pose) {
  const bool finite = pose.centre_w.allFinite() && pose.frame_w.allFinite() &&
                      pose.velocity_w.allFinite() && pose.angular_velocity_w.allFinite();
  if (!finite) throw std::runtime_error("the pose or velocity of the wheel is not finite");
  if (pose.centre_w.cwiseAbs().maxCoeff() > kFarthest) {
    throw std::runtime_error("the wheel is more than " + Shown(kFarthest) + " m from the origin");
  }
}

double ClosingSpeed(const TirePose& pose, const SurfacePoint& ground) {
  return ground.undisturbed_x * pose.velocity_w.x() + ground.undisturbed_y * pose.velocity_w.y() -
         pose.velocity_w.z();
}

double ShearLead(double speed, double K) {
  return speed * kShearLead > kLongestLead * K ? kLongestLead * K / speed : kShearLead;
}

}  // namespace softsoil
