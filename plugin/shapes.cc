#include "plugin/shapes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "plugin/mesh_geom.h"
#include "plugin/model_geometry.h"
#include "plugin/tire_pose.h"
#include "terrain/input_error.h"

namespace softsoil {
namespace {

using Eigen::Vector3d;

constexpr double kSoilFriction = 0.5;     // steel on soil (Potyondy 1961: 0.54 to 0.79 of phi)
constexpr double kStiffnessShare = 0.25;  // of m / h^2
constexpr double kDampingRatio = 0.1;     // of critical
constexpr double kStiffest = 1e10;        // [Pa/m]  also where the mass is infinite

TriangleMesh SeenFrom(const Vector3d& origin, const Eigen::Matrix3d& frame, TriangleMesh mesh) {
  for (Vector3d& v : mesh.vertices) v = frame.transpose() * (v - origin);
  return mesh;
}

// Of a wheel that turns: about its axis, the middle of the tread where the mesh has its middle.
void SetTurning(const TriangleMesh& mesh_b, Wheel* wheel) {
  const Eigen::Matrix3d frame = TireFrame(wheel->axis_b);
  const Extent extent = ExtentOf(SeenFrom(wheel->centre_b, frame, mesh_b));
  wheel->centre_b += extent.Middle().y() * frame.col(1);
  wheel->half_width = extent.Size().y() / 2;
  TriangleMesh mesh = SeenFrom(wheel->centre_b, frame, mesh_b);
  wheel->radius = RadiusAboutY(mesh);
  wheel->mesh = std::make_shared<TriangleMesh>(std::move(mesh));
}

// Of a body that does not turn: its width is the lesser one along the body's x and y axes.
void SetFixed(const TriangleMesh& mesh_b, Wheel* wheel) {
  const Extent extent = ExtentOf(mesh_b);
  wheel->centre_b = extent.Middle();
  wheel->axis_b = Vector3d::UnitY();
  wheel->half_width = extent.Size().head<2>().minCoeff() / 2;
  wheel->radius = extent.Size().maxCoeff() / 2;
  wheel->mesh =
      std::make_shared<TriangleMesh>(SeenFrom(wheel->centre_b, TireFrame(wheel->axis_b), mesh_b));
}

int GeomWithName(const mjModel* m, const std::string& name) {
  for (int geom = 0; geom < m->ngeom; ++geom) {
    if (name == m->names + m->name_geomadr[geom]) return geom;
  }
  throw InputError("the model has no geom \"" + name + "\"");
}

// The wheel that the geom belongs to, perhaps a new one.
Wheel* WheelOf(const mjModel* m, int geom, std::vector<Wheel>* wheels) {
  const int body = m->geom_bodyid[geom];
  if (m->body_weldid[body] == 0) {
    throw InputError(GeomName(m, geom) + " is fixed to the world: its body must be able to move");
  }
  for (Wheel& wheel : *wheels) {
    if (wheel.body == body) return &wheel;
    if (wheel.joint < 0 || m->body_weldid[wheel.body] != m->body_weldid[body]) continue;
    throw InputError(GeomName(m, geom) + " must be of the same body as wheel \"" + wheel.name +
                     "\", with which it turns, got " + BodyName(m, body));
  }
  wheels->push_back(TurningBody(m, body));
  return &wheels->back();
}

// Area [m^2] of the largest of the mesh's three views along its axes.
double LargestView(const TriangleMesh& mesh) {
  Vector3d views = Vector3d::Zero();
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
    views += AreaVector(mesh, t).cwiseAbs() / 2;
  }
  return views.maxCoeff();
}

}  // namespace

void AddShapes(const mjModel* m, const std::vector<std::string>& geoms,
               std::vector<Wheel>* wheels) {
  At("softsoil_shapes", [&] {
    for (const std::string& name : geoms) {
      const int geom = GeomWithName(m, name);
      const TriangleMesh mesh_b = MeshOfGeom(m, geom);
      Wheel* wheel = WheelOf(m, geom, wheels);
      if (wheel->mesh != nullptr && wheel->geom == geom) {
        throw InputError(GeomName(m, geom) + " is named twice");
      }
      if (wheel->mesh != nullptr) {
        throw InputError(BodyName(m, wheel->body) + " must have one shape, got two: " +
                         GeomName(m, wheel->geom) + " and " + GeomName(m, geom));
      }
      wheel->outline = WheelOutline::kMesh;
      wheel->geom = geom;
      wheel->joint < 0 ? SetFixed(mesh_b, wheel) : SetTurning(mesh_b, wheel);
    }
  });
}

Tire RigidTire(const mjModel* m, const Wheel& wheel) {
  Tire tire;
  tire.name = kRigidTire;
  tire.description = "rigid shape";
  tire.soil_friction = kSoilFriction;
  const double h = m->opt.timestep, area = LargestView(*wheel.mesh);
  const double mass = 1 / m->body_invweight0[2 * wheel.body];  // [kg]  infinite of a mocap body
  tire.spring.linear = std::min(kStiffnessShare * mass / (h * h) / area, kStiffest);
  const double critical =
      2 * h * tire.spring.linear / std::sqrt(kStiffnessShare);  // 2 sqrt(k m), by area
  tire.damping = kDampingRatio * critical;
  return WithShape(tire, wheel);
}

Tire WithShape(Tire tire, const Wheel& wheel) {
  tire.mesh = wheel.mesh;
  tire.shape = {wheel.radius, std::numeric_limits<double>::infinity(), 2 * wheel.half_width};
  return tire;
}

}  // namespace softsoil
