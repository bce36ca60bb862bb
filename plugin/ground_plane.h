// The undisturbed ground: a plane geom of the world.
#pragma once

#include <mujoco/mujoco.h>

#include <Eigen/Core>
#include <string>

#include "terrain/surface.h"

namespace softsoil {

struct GroundPlane {
  int geom;
  UndisturbedHeight height;
  Eigen::Vector3d point_w = Eigen::Vector3d::Zero();  // [m]  of the plane
  Eigen::Vector3d normal_w = Eigen::Vector3d::UnitZ();
};

// The plane geom with the given name, or the only one if the name is empty. It must be fixed to
// the world and at most 60 degrees from level; gravity must act along -z. Throws InputError.
GroundPlane FindGroundPlane(const mjModel* m, const std::string& name);

}  // namespace softsoil
