// Finds the wheels of a model by their geoms and hinges.
//
// A wheel is a body with a geom that is round about a spin axis: an unlimited hinge of the body, or
// of the body it is welded to, that is within 2 degrees of the geom's axis, passes its centre
// within 5 % of its radius, and is nearer to level than to upright at qpos0. Of several round
// geoms side by side on one hinge each body gives one wheel; of geoms that overlap along the hinge
// one counts: colliding ones before visual ones, then the largest.
#pragma once

#include <mujoco/mujoco.h>

#include <Eigen/Core>
#include <memory>
#include <string>
#include <vector>

#include "contact/triangle_mesh.h"

namespace softsoil {

// Outline of a wheel in the plane of its axis.
enum class WheelOutline { kCylinder, kCapsule, kEllipsoid, kSphere, kMesh, kUnknown };

struct Wheel {
  int body;
  std::string name;          // of the body, "body 7" if it has none
  int joint;                 // the spin axis; -1: it does not turn
  Eigen::Vector3d centre_b;  // [m]  on the spin axis; _b: frame of the body
  Eigen::Vector3d axis_b;    // [-]  spin axis; points to the left of the vehicle at qpos0
  WheelOutline outline;      // kUnknown: a named body without a round geom, e.g. a mesh
  double radius;             // [m]  0 if unknown
  double half_width;         // [m]  half the extent along the axis; of a capsule without its caps
  int geom;                  // -1 if unknown
  std::shared_ptr<const TriangleMesh> mesh = nullptr;  // of kMesh, in the tire frame
};

// The wheels among the `named` bodies, or all if none is named. Throws InputError if a body is
// unknown or has no spin axis, or if there are no wheels at all; that only if they are `needed`.
std::vector<Wheel> FindWheels(const mjModel* m, const std::vector<std::string>& named,
                              bool needed = true);

// A body as a wheel of unknown outline; one that does not turn if it has no spin axis.
Wheel TurningBody(const mjModel* m, int body);

}  // namespace softsoil
