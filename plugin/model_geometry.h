// Names and poses that follow from a mjModel alone.
#pragma once

#include <mujoco/mujoco.h>

#include <Eigen/Core>
#include <string>

namespace softsoil {

// Where a frame is, seen from another one.
struct Frame {
  Eigen::Vector3d position;     // [m]
  Eigen::Matrix3d orientation;  // [-]  columns: its axes
};
Frame operator*(const Frame& outer, const Frame& inner);
Frame FrameAt(const mjtNum position[3], const mjtNum quaternion[4]);

// Pose of a body at qpos0, seen from an ancestor of it (0: the world).
Frame PoseAtStart(const mjModel* m, int body, int ancestor);

Eigen::Vector3d Vector(const mjtNum v[3]);

// Name in quotes; of a nameless body or geom its number: body 7.
std::string BodyName(const mjModel* m, int body);
std::string GeomName(const mjModel* m, int geom);
// The bare name, "body 7" if it has none.
std::string WheelName(const mjModel* m, int body);

}  // namespace softsoil
