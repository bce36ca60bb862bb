// What a wheel does, in the terms of vehicle and terramechanics engineers.
//
// Axes and signs, used here and nowhere else described: the W axes of contact/wheel_axes.h: x
// forward, y to the left, z up along the normal of the undisturbed ground below the wheel. On a
// slope the weight of the vehicle thus counts in no wheel's resistance.
// Forces and torques are those of the ground on the wheel. A wheel that rolls forward has a
// positive spin.
//   slip ratio   (r w - v) / v with the unloaded radius r, spin w, forward speed v (4.8); positive
//                when driven. Below 0.01 m/s that speed stands in for v.
//   slip angle   atan2(v_y, |v_x|): positive when the wheel slides to the left; 0 below 0.01 m/s.
//   camber       rotation of the wheel plane about x: positive when its top leans to the right.
#pragma once

#include "contact/wheel_contact.h"

namespace softsoil {

struct WheelReport {
  double load;               // [N]   along z
  double sinkage;            // [m]   deepest contact below the undisturbed ground
  double rut_depth;          // [m]   deepest surface below the wheel, of what stays
  double slip_ratio;         // [-]
  double slip_angle;         // [rad]
  double camber;             // [rad]
  double spin;               // [rad/s]
  double forward_speed;      // [m/s]
  double thrust;             // [N]   forward part of the shear forces
  double motion_resistance;  // [N]   rearward part of the normal forces
  double drawbar_pull;       // [N]   thrust - motion resistance
  double lateral_force;      // [N]   along y
  double torque;             // [N m] that drives the wheel against the ground: minus the ground's
                             //       torque about the spin axis
  double contact_area;       // [m^2]
  double mean_pressure;      // [Pa]
  double peak_pressure;      // [Pa]
};

WheelReport ReportOf(const Tire& tire, const TirePose& pose, const PatchForces& forces);

}  // namespace softsoil
