#include "contact/tire.h"

#include <limits>

namespace softsoil {

const std::vector<Attribute<Tire>>& TireAttributes() {
  using R = Range;
  static const std::vector<Attribute<Tire>> table = {
      {"shape", "radius", "m", 1, R::kPositive, "outer radius, unloaded",
       [](Tire& t) -> double& { return t.shape.radius; }},
      {"shape", "width", "m", 1, R::kPositive, "width of the tread",
       [](Tire& t) -> double& { return t.shape.width; }},
      {"spring", "coefficient", "Pa/m or Pa/m^0.5", 1, R::kPositive,
       "pressure per penetration (linear) or per its root (square_root)",
       [](Tire& t) -> double& { return t.spring.coefficient; }},
      {"spring", "damping", "Pa s/m", 1, R::kNotNegative, "pressure per speed of penetration",
       [](Tire& t) -> double& { return t.damping; }},
      {"friction", "coefficient", "", 1, R::kPositive, "friction between tire and soil",
       [](Tire& t) -> double& { return t.soil_friction; }},
  };
  return table;
}

namespace {

Tire ReadTire(XmlEntry& entry) {
  Tire tire{};
  tire.name = entry.name();
  tire.description = entry.description();
  entry.Fill(TireAttributes(), tire);
  tire.spring.form = entry.Text("spring", "form", {"linear", "square_root"}) == "linear"
                         ? SpringForm::kLinear
                         : SpringForm::kSquareRoot;
  tire.shape.crown_radius = std::numeric_limits<double>::infinity();
  if (entry.Text("shape", "type", {"torus", "cylinder"}) == "torus") {
    tire.shape.crown_radius = entry.Number("shape", "crown_radius", "m", Range::kPositive);
    if (tire.shape.crown_radius < tire.shape.width / 2) {
      entry.Refuse("crown_radius must be >= width / 2 = " + Shown(tire.shape.width / 2) +
                   " m, got " + Shown(tire.shape.crown_radius));
    }
  }
  return tire;
}

}  // namespace

Catalogue<Tire> TireCatalogue() { return {"tire", ReadTire}; }

}  // namespace softsoil
