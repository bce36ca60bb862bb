// What happens at each node of a tire in contact, in the terms of terramechanics engineers.
#pragma once

#include <vector>

#include "contact/wheel_contact.h"

namespace softsoil {

// Forces are those of the ground on the wheel. Forward, left and ahead as in contact/wheel_axes.h:
// the way the vehicle faces counts, not the way it drives.
struct PatchPoint {
  Eigen::Vector3d position_w;      // [m]    of the deformed tire
  Eigen::Vector3d normal_force_w;  // [N]
  Eigen::Vector3d shear_force_w;   // [N]
  Eigen::Vector3d flank_force_w;   // [N]    on the edge of the tread: contact/flank.h
  double angle;                    // [rad]  along the circumference from the lowest point of the
                                   //        wheel, along the normal of the ground; positive ahead
  double lateral;                  // [m]    from the middle plane, positive to the left
  double pressure;                 // [Pa]
  double shear;                    // [Pa]   along the circumference, positive where it drives the
                                   //        wheel forward
  double shear_across;             // [Pa]   across the tread, positive to the left
  double area;                     // [m^2]
  double depth;                    // [m]    below the undisturbed ground
};

// Every node in contact, in the order of the nodes; empty in the air. `nodes` of the tire whose
// contact gave `forces` at `pose`.
std::vector<PatchPoint> PatchReportOf(const TireNodes& nodes, const TirePose& pose,
                                      const PatchForces& forces);

}  // namespace softsoil
