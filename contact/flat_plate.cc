#include "contact/flat_plate.h"

#include <algorithm>

#include "contact/tire_nodes.h"

namespace softsoil {

double FlatPlateLoad(const Tire& tire, double z, double node_spacing) {
  const TireNodes nodes = MakeTireNodes(tire.shape, node_spacing);
  const double plate = z - tire.shape.radius;  // height, from the wheel centre
  double load = 0;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const double below = plate - nodes.position_t[i].z();
    const double cosine = -nodes.radial_t[i].z();
    if (below <= 0 || cosine <= 0) continue;
    const double d = std::min(below / cosine, nodes.radius[i]);
    load += SpringPressure(tire.spring, d) * LoadedArea(nodes.area[i], nodes.radius[i], d) *
            -nodes.normal_t[i].z();
  }
  return load;
}

}  // namespace softsoil
