#include "contact/tread_strength.h"

#include <algorithm>
#include <cmath>

#include "contact/tread_rows.h"
#include "terrain/earth_pressure.h"

namespace softsoil {
namespace {

// Share [-] of the faces of the lugs that lies across the slip: of bars at an angle all that slip
// along the wheel meets, and its tangent of what slip across does.
double Facing(const Lugs& lugs, const Mobilisation& mobilised) {
  const double all = std::hypot(mobilised.t, mobilised.b);
  if (all <= 0) return 1;
  return std::hypot(mobilised.t, std::tan(lugs.angle) * mobilised.b) / all;
}

class LuggedRow {
 public:
  LuggedRow(const Tire& tire, const TireNodes& nodes, const SoilMap& soils, const TreadRow& row,
            std::vector<NodeContact>* contacts)
      : tire_(tire), soils_(soils), row_(row), contacts_(*contacts) {
    const int node = contacts_[row.first].node;
    on_lug_ = nodes.on_lug[node];
    length_ = nodes.length[node];
  }

  void Fill() {
    const double side_stress = SideStress();
    FillSides([&](const Shear& soil) {
      return on_lug_ ? ShearStrength(soil, tire_.soil_friction, side_stress)
                     : MohrCoulomb(soil, side_stress);
    });
    if (on_lug_) return;
    double sliding = 0, wedge = 0;  // [N]
    for (int i = row_.first; i < row_.end; ++i) {
      NodeContact& c = contacts_[i];
      if (c.engaged > 0) sliding += MohrCoulomb(soils_[c.soil].shear, c.pressure) * c.area;
      sliding += c.side_strength;
      c.strength += PassiveStrength(c);
      wedge += c.strength * c.area;
    }
    if (sliding > wedge) {
      FillSides([](const Shear&) { return 0.0; });
      return;
    }
    for (int i = row_.first; i < row_.end; ++i) {
      NodeContact& c = contacts_[i];
      c.strength = c.engaged > 0 ? MohrCoulomb(soils_[c.soil].shear, c.pressure) : 0;
    }
  }

 private:
  // [Pa]  of the wedge before a lug, by area of the tread.
  double PassiveStrength(const NodeContact& c) const {
    const Lugs& lugs = tire_.shape.lugs;
    const Soil& soil = soils_[c.soil];
    return Facing(lugs, c.mobilised) * PassiveForce(soil.shear, UnitWeight(soil), c.engaged) /
           LugGap(lugs, tire_.shape.radius);
  }
  double SideStress() const {
    double load = 0;  // [N]
    for (int i = row_.first; i < row_.end; ++i) {
      load += contacts_[i].tread_pressure * contacts_[i].area;
    }
    const double width = tire_.shape.width;
    return softsoil::SideStress(load / (width * length_), tire_.shape.lugs.height, width);
  }
  // strength(Shear) [Pa] of a side in the soil where it stands.
  template <class Strength>
  void FillSides(const Strength& strength) {
    for (const int edge : {row_.right, row_.left}) {
      if (edge < 0) continue;
      NodeContact& c = contacts_[edge];
      const int sides = row_.right == row_.left ? 2 : 1;
      c.side_strength = sides * strength(soils_[c.soil].shear) * std::max(0.0, c.engaged) * length_;
    }
  }

  const Tire& tire_;
  const SoilMap& soils_;
  TreadRow row_;
  std::vector<NodeContact>& contacts_;
  bool on_lug_;
  double length_;  // [m]  along the circumference
};

}  // namespace

void FillStrength(const Tire& tire, const TireNodes& nodes, const SoilMap& soils,
                  std::vector<NodeContact>* contacts) {
  for (NodeContact& c : *contacts) {
    c.strength = ShearStrength(soils[c.soil].shear, tire.soil_friction, c.pressure);
    c.side_strength = 0;
  }
  if (!tire.shape.lugs) return;
  ForEachRow(*contacts, nodes.rings,
             [&](const TreadRow& row) { LuggedRow(tire, nodes, soils, row, contacts).Fill(); });
}

}  // namespace softsoil
