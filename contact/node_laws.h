// What the nodes of any shape on soft ground have in common.
#pragma once

#include <optional>

#include "contact/wheel_contact.h"
#include "terrain/earth_pressure.h"

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

// The strength of all soils, each worked out when it is asked for: neighbours mostly lie in the
// same.
class SoilStrengths {
 public:
  // The soils must outlive the object.
  explicit SoilStrengths(const SoilMap& soils) : soils_(soils) {}

  struct OfSoil {
    Strength shear;
    PassiveStrength passive;
    double unit_weight;  // [N/m^3]
  };
  const OfSoil& In(int soil) {  // valid until the next question
    if (soil != soil_)
      of_soil_ = {soils_[soil].shear, soils_[soil].shear, UnitWeight(soils_[soil])};
    soil_ = soil;
    return *of_soil_;
  }

 private:
  const SoilMap& soils_;
  int soil_ = -1;  // whose strength it is
  std::optional<OfSoil> of_soil_;
};

// Time [s] that the shear stress looks ahead at a slip of `speed` [m/s].
double ShearLead(double speed, double K);

}  // namespace softsoil
