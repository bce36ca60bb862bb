#include "plugin/ground_plane.h"

#include <cmath>
#include <vector>

#include "plugin/model_geometry.h"
#include "terrain/constants.h"
#include "terrain/input_error.h"

namespace softsoil {
namespace {

using Eigen::Vector3d;

constexpr double kSteepestDegrees = 60;

bool IsFixedPlane(const mjModel* m, int geom) {
  return m->geom_type[geom] == mjGEOM_PLANE && m->body_weldid[m->geom_bodyid[geom]] == 0;
}

int OnlyPlane(const mjModel* m) {
  std::vector<int> planes;
  std::vector<std::string> names;
  for (int geom = 0; geom < m->ngeom; ++geom) {
    if (!IsFixedPlane(m, geom)) continue;
    planes.push_back(geom);
    names.push_back(GeomName(m, geom));
  }
  if (planes.size() == 1) return planes[0];
  throw InputError(planes.empty() ? "no ground: the world must have a geom of type plane"
                                  : "which plane is the ground? Name one of " + Listed(names) +
                                        " in <custom> <text name=\"softsoil_ground\">");
}

int PlaneWithName(const mjModel* m, const std::string& name) {
  for (int geom = 0; geom < m->ngeom; ++geom) {
    if (m->names + m->name_geomadr[geom] != name) continue;
    if (IsFixedPlane(m, geom)) return geom;
    throw InputError("softsoil_ground: " + GeomName(m, geom) +
                     " must be of type plane and fixed to the world");
  }
  throw InputError("softsoil_ground: the model has no geom \"" + name + "\"");
}

void RequireGravityDown(const mjModel* m) {
  const Vector3d g = Vector(m->opt.gravity);
  if (g.x() == 0 && g.y() == 0 && g.z() < 0) return;
  throw InputError("<option> gravity: must act along -z, got " + Shown(g.x()) + " " + Shown(g.y()) +
                   " " + Shown(g.z()));
}

}  // namespace

GroundPlane FindGroundPlane(const mjModel* m, const std::string& name) {
  RequireGravityDown(m);
  const int geom = name.empty() ? OnlyPlane(m) : PlaneWithName(m, name);
  const Frame plane = PoseAtStart(m, m->geom_bodyid[geom], 0) *
                      FrameAt(m->geom_pos + 3 * geom, m->geom_quat + 4 * geom);
  const Vector3d normal_w = plane.orientation.col(2), point_w = plane.position;
  const double degrees = std::acos(std::min(1.0, normal_w.z())) * kDegrees;
  if (degrees > kSteepestDegrees + 1e-9) {
    throw InputError("the ground, " + GeomName(m, geom) + ", must be at most " +
                     Shown(kSteepestDegrees) + " degrees from level, got " +
                     Shown(std::round(degrees * 1000) / 1000));
  }
  const double slope_x = -normal_w.x() / normal_w.z(), slope_y = -normal_w.y() / normal_w.z();
  const auto height = [=](double x, double y) {
    return point_w.z() + slope_x * (x - point_w.x()) + slope_y * (y - point_w.y());
  };
  return {geom, height, point_w, normal_w};
}

}  // namespace softsoil
