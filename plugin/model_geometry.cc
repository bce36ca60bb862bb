#include "plugin/model_geometry.h"

#include <Eigen/Geometry>

namespace softsoil {
namespace {

std::string Named(const mjModel* m, const char* kind, int address, int id) {
  const std::string name = m->names + address;
  return name.empty() ? std::string(kind) + " " + std::to_string(id)
                      : std::string(kind) + " \"" + name + "\"";
}

}  // namespace

Frame operator*(const Frame& outer, const Frame& inner) {
  return {outer.position + outer.orientation * inner.position,
          outer.orientation * inner.orientation};
}

Eigen::Vector3d Vector(const mjtNum v[3]) { return {v[0], v[1], v[2]}; }

Frame FrameAt(const mjtNum position[3], const mjtNum quaternion[4]) {
  const Eigen::Quaterniond q(quaternion[0], quaternion[1], quaternion[2], quaternion[3]);
  return {Vector(position), q.normalized().toRotationMatrix()};
}

Frame PoseAtStart(const mjModel* m, int body, int ancestor) {
  Frame pose{Eigen::Vector3d::Zero(), Eigen::Matrix3d::Identity()};
  for (int b = body; b != ancestor; b = m->body_parentid[b]) {
    pose = FrameAt(m->body_pos + 3 * b, m->body_quat + 4 * b) * pose;
  }
  return pose;
}

std::string BodyName(const mjModel* m, int body) {
  return Named(m, "body", m->name_bodyadr[body], body);
}

std::string GeomName(const mjModel* m, int geom) {
  return Named(m, "geom", m->name_geomadr[geom], geom);
}

std::string WheelName(const mjModel* m, int body) {
  const std::string name = m->names + m->name_bodyadr[body];
  return name.empty() ? "body " + std::to_string(body) : name;
}

}  // namespace softsoil
