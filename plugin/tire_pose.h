// Where the tire of a wheel is in a simulation, and how it moves.
#pragma once

#include <mujoco/mujoco.h>

#include <Eigen/Core>

#include "contact/wheel_contact.h"
#include "plugin/wheel_finder.h"

namespace softsoil {

// Axes of a tire as columns: y along the spin axis, x and z any two across it.
Eigen::Matrix3d TireFrame(const Eigen::Vector3d& spin_axis);

// tire_frame_b: the axes in the frame of the wheel's body.
TirePose PoseOf(const mjModel* m, const mjData* d, const Wheel& wheel,
                const Eigen::Matrix3d& tire_frame_b);

}  // namespace softsoil
