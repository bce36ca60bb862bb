#include "contact/tire.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>

#include "contact/mesh_file.h"
#include "contact/tire_family.h"
#include "contact/tire_nodes.h"

namespace softsoil {

const std::vector<Attribute<Tire>>& TireAttributes() {
  using R = Range;
  static const std::vector<Attribute<Tire>> table = {
      {"shape", "radius", "m", 1, R::kTireSize, "outer radius, unloaded",
       [](Tire& t) -> double& { return t.shape.radius; }},
      {"shape", "width", "m", 1, R::kTireSize, "width of the tread",
       [](Tire& t) -> double& { return t.shape.width; }},
      {"spring", "linear", "Pa/m", 1, R::kNotNegative, "pressure per penetration",
       [](Tire& t) -> double& { return t.spring.linear; }, true},
      {"spring", "quadratic", "Pa/m^2", 1, R::kNotNegative, "pressure per square of penetration",
       [](Tire& t) -> double& { return t.spring.quadratic; }, true},
      {"spring", "cubic", "Pa/m^3", 1, R::kNotNegative, "pressure per cube of penetration",
       [](Tire& t) -> double& { return t.spring.cubic; }, true},
      {"spring", "root", "Pa/m^0.5", 1, R::kNotNegative, "pressure per square root of penetration",
       [](Tire& t) -> double& { return t.spring.root; }, true},
      {"spring", "damping", "Pa s/m", 1, R::kNotNegative,
       "pressure per speed at which the wheel nears the ground",
       [](Tire& t) -> double& { return t.damping; }},
      {"friction", "coefficient", "", 1, R::kPositive, "friction between tire and soil",
       [](Tire& t) -> double& { return t.soil_friction; }},
  };
  return table;
}

// A tire so wide or so strongly curved has no sensible cloud of nodes.
std::string ShapeFault(const TireShape& shape) {
  if (shape.width > kWidestPerRadius * shape.radius) {
    return "width must be <= 10 radius = " + Shown(kWidestPerRadius * shape.radius) + " m, got " +
           Shown(shape.width);
  }
  if (shape.crown_radius < shape.width / 2) {
    return "crown_radius must be >= width / 2 = " + Shown(shape.width / 2) + " m, got " +
           Shown(shape.crown_radius);
  }
  if (RadiusAt(shape, shape.width / 2) <= 0) {
    return "radius must be > 0 m at the edge of the tread, got " +
           Shown(RadiusAt(shape, shape.width / 2)) + " from crown_radius " +
           Shown(shape.crown_radius) + " and width " + Shown(shape.width);
  }
  return "";
}

namespace {

std::shared_ptr<const TriangleMesh> ReadTireMesh(XmlEntry& entry, const TireShape& shape) {
  for (const char* element : {"lugs", "inflation"}) {
    if (entry.Has(element)) {
      entry.Refuse(std::string("a tire with a <mesh> must have no <") + element + ">");
    }
  }
  if (std::isfinite(shape.crown_radius)) {
    entry.Refuse("a tire with a <mesh> must have the shape cylinder, got torus");
  }
  const std::filesystem::path file = entry.Text("mesh", "file");
  const double scale =
      entry.Has("mesh", "scale") ? entry.Number("mesh", "scale", "", Range::kPositive) : 1;
  const std::string path = (std::filesystem::path(entry.file()).parent_path() / file).string();
  std::shared_ptr<TriangleMesh> mesh;
  try {
    mesh = std::make_shared<TriangleMesh>(ReadMesh(path, scale));
  } catch (const InputError& error) {
    entry.Refuse(error.what());
  }
  const Extent extent = ExtentOf(*mesh);
  if (std::abs(extent.Middle().y()) > kSameSize * extent.Size().y()) {
    entry.Refuse("the mesh must have its middle at y = 0 m, got " + Shown(extent.Middle().y()));
  }
  const auto require = [&](const char* name, double ours, double theirs) {
    if (std::abs(ours - theirs) <= kSameSize * theirs) return;
    entry.Refuse(std::string(name) + " must be that of the mesh, " + Shown(ours) +
                 " m about its y axis, got " + Shown(theirs));
  };
  require("radius", RadiusAboutY(*mesh), shape.radius);
  require("width", extent.Size().y(), shape.width);
  return mesh;
}

Tire ReadTire(XmlEntry& entry) {
  Tire tire{};
  tire.name = entry.name();
  tire.description = entry.description();
  entry.Fill(TireAttributes(), tire);
  tire.shape.crown_radius = std::numeric_limits<double>::infinity();
  if (entry.Text("shape", "type", {"torus", "cylinder"}) == "torus") {
    tire.shape.crown_radius = entry.Number("shape", "crown_radius", "m", Range::kTireSize);
  }
  const std::string fault = ShapeFault(tire.shape);
  if (!fault.empty()) entry.Refuse(fault);
  tire.shape.lugs = ReadLugs(entry, tire.shape.radius, RadiusAt(tire.shape, tire.shape.width / 2));
  if (entry.Has("mesh")) tire.mesh = ReadTireMesh(entry, tire.shape);
  if (SpringPressure(tire.spring, 1) <= 0) {
    entry.Refuse("the spring must have one of linear, quadratic, cubic, root > 0");
  }
  if (entry.Has("inflation")) {
    tire.family = entry.Text("inflation", "family");
    tire.inflation_pressure = entry.Number("inflation", "pressure", "Pa", Range::kPositive);
  }
  return tire;
}

}  // namespace

Catalogue<Tire> TireCatalogue() { return {"tire", ReadTire, RequireAgreement}; }

}  // namespace softsoil
