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
  LuggedRow(const Tire& tire, const TireNodes& nodes, const Soil& soil, const TreadRow& row,
            std::vector<NodeContact>* contacts)
      : tire_(tire), soil_(soil), row_(row), contacts_(*contacts) {
    const int node = contacts_[row.first].node;
    on_lug_ = nodes.on_lug[node];
    length_ = nodes.length[node];
    gamma_ = UnitWeight(soil);
  }

  void Fill() {
    const double side_stress = SideStress();
    if (on_lug_) {
      FillSides(ShearStrength(soil_.shear, tire_.soil_friction, side_stress));
      return;
    }
    FillSides(MohrCoulomb(soil_.shear, side_stress));
    const double tan_phi = std::tan(soil_.shear.friction_angle);
    double sliding = 0, wedge = 0;  // [N]
    for (int i = row_.first; i < row_.end; ++i) {
      NodeContact& c = contacts_[i];
      if (c.engaged > 0) sliding += (soil_.shear.cohesion + c.pressure * tan_phi) * c.area;
      sliding += c.side_strength;
      c.strength += PassiveStrength(c);
      wedge += c.strength * c.area;
    }
    if (sliding > wedge) {
      FillSides(0);
      return;
    }
    for (int i = row_.first; i < row_.end; ++i) {
      NodeContact& c = contacts_[i];
      c.strength = c.engaged > 0 ? soil_.shear.cohesion + c.pressure * tan_phi : 0;
    }
  }

 private:
  // [Pa]  of the wedge before a lug, by area of the tread.
  double PassiveStrength(const NodeContact& c) const {
    const Lugs& lugs = tire_.shape.lugs;
    return Facing(lugs, c.mobilised) * PassiveForce(soil_.shear, gamma_, c.engaged) /
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
  void FillSides(double strength) {
    for (const int edge : {row_.right, row_.left}) {
      if (edge < 0) continue;
      NodeContact& c = contacts_[edge];
      const int sides = row_.right == row_.left ? 2 : 1;
      c.side_strength = sides * strength * std::max(0.0, c.engaged) * length_;
    }
  }

  const Tire& tire_;
  const Soil& soil_;
  TreadRow row_;
  std::vector<NodeContact>& contacts_;
  bool on_lug_;
  double length_;  // [m]      along the circumference
  double gamma_;   // [N/m^3]  unit weight
};

}  // namespace

void FillStrength(const Tire& tire, const TireNodes& nodes, const Soil& soil,
                  std::vector<NodeContact>* contacts) {
  for (NodeContact& c : *contacts) {
    c.strength = ShearStrength(soil.shear, tire.soil_friction, c.pressure);
    c.side_strength = 0;
  }
  if (!tire.shape.lugs) return;
  ForEachRow(*contacts, nodes.rings,
             [&](const TreadRow& row) { LuggedRow(tire, nodes, soil, row, contacts).Fill(); });
}

}  // namespace softsoil
