// The W axes of TYDEX (Standard Tire Interface), the z-up form of SAE J670, of one wheel.
#pragma once

#include "contact/wheel_contact.h"

namespace softsoil {

// They lie in the undisturbed ground below the wheel, unit vectors in world axes.
struct WheelAxes {
  Eigen::Vector3d forward_w;  // x  in the plane of the wheel, the way the vehicle faces
  Eigen::Vector3d left_w;     // y
  Eigen::Vector3d up_w;       // z  normal to the ground
};

// `patch` is the surface below the wheel, of the last evaluation; before any the ground is level. A
// wheel that lies on its side faces any way.
WheelAxes WheelAxesOf(const TirePose& pose, const SurfacePatch& patch);

}  // namespace softsoil
