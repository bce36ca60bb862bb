#include "contact/tread_strength.h"

#include <algorithm>
#include <cmath>

#include "contact/node_laws.h"
#include "contact/tread_rows.h"

namespace softsoil {
namespace {

// Share [-] of the faces of the lugs that lies across the slip: of bars at an angle all that slip
// along the wheel meets, and its tangent of what slip across does.
double Facing(double tan_angle, const Mobilisation& mobilised) {
  const auto length = [](double a, double b) { return std::sqrt(a * a + b * b); };
  const double all = length(mobilised.t, mobilised.b);
  if (all <= 0) return 1;
  return length(mobilised.t, tan_angle * mobilised.b) / all;
}

// The same for all rows.
struct Tread {
  const Tire& tire;
  const TireNodes& nodes;
  SoilStrengths& soils;
  double tan_angle, gap;  // [-], [m]  of the lugs
};

class LuggedRow {
 public:
  LuggedRow(const Tread& tread, const TreadRow& row, std::vector<NodeContact>* contacts)
      : tread_(tread), row_(row), contacts_(*contacts) {
    const int node = contacts_[row.first].node;
    on_lug_ = tread.nodes.on_lug[node];
    length_ = tread.nodes.length[node];
  }

  void Fill() {
    const double side_stress = SideStress();
    FillSides([&](const Strength& soil) {
      return on_lug_ ? ShearStrength(soil, tread_.tire.soil_friction, side_stress)
                     : MohrCoulomb(soil, side_stress);
    });
    if (on_lug_) return;
    double sliding = 0, wedge = 0;  // [N]
    for (int i = row_.first; i < row_.end; ++i) {
      NodeContact& c = contacts_[i];
      if (c.engaged > 0) sliding += MohrCoulomb(StrengthOf(c), c.pressure) * c.area;
      sliding += c.side_strength;
      c.strength += PassiveStrength(c);
      wedge += c.strength * c.area;
    }
    if (sliding > wedge) {
      FillSides([](const Strength&) { return 0.0; });
      return;
    }
    for (int i = row_.first; i < row_.end; ++i) {
      NodeContact& c = contacts_[i];
      c.strength = c.engaged > 0 ? MohrCoulomb(StrengthOf(c), c.pressure) : 0;
    }
  }

 private:
  const Strength& StrengthOf(const NodeContact& c) const { return tread_.soils.In(c.soil).shear; }
  // [Pa]  of the wedge before a lug, by area of the tread.
  double PassiveStrength(const NodeContact& c) const {
    const SoilStrengths::OfSoil& soil = tread_.soils.In(c.soil);
    return Facing(tread_.tan_angle, c.mobilised) *
           PassiveForce(soil.passive, soil.unit_weight, c.engaged) / tread_.gap;
  }
  double SideStress() const {
    double load = 0;  // [N]
    for (int i = row_.first; i < row_.end; ++i) {
      load += contacts_[i].tread_pressure * contacts_[i].area;
    }
    const double width = tread_.tire.shape.width;
    return softsoil::SideStress(load / (width * length_), tread_.tire.shape.lugs.height, width);
  }
  // strength(Strength) [Pa] of a side in the soil where it stands.
  template <class Strength>
  void FillSides(const Strength& strength) {
    for (const int edge : {row_.right, row_.left}) {
      if (edge < 0) continue;
      NodeContact& c = contacts_[edge];
      const int sides = row_.right == row_.left ? 2 : 1;
      c.side_strength = sides * strength(StrengthOf(c)) * std::max(0.0, c.engaged) * length_;
    }
  }

  const Tread& tread_;
  TreadRow row_;
  std::vector<NodeContact>& contacts_;
  bool on_lug_;
  double length_;  // [m]  along the circumference
};

}  // namespace

void FillStrength(const Tire& tire, const TireNodes& nodes, const SoilMap& soils,
                  std::vector<NodeContact>* contacts) {
  SoilStrengths strengths(soils);
  for (NodeContact& c : *contacts) {
    c.strength = ShearStrength(strengths.In(c.soil).shear, tire.soil_friction, c.pressure);
    c.side_strength = 0;
  }
  const Lugs& lugs = tire.shape.lugs;
  if (!lugs) return;
  const Tread tread = {tire, nodes, strengths, std::tan(lugs.angle),
                       LugGap(lugs, tire.shape.radius)};
  ForEachRow(*contacts, nodes.rings,
             [&](const TreadRow& row) { LuggedRow(tread, row, contacts).Fill(); });
}

}  // namespace softsoil
