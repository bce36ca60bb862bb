// How steep soil stands at each grid node.
#pragma once

#include <vector>

#include "terrain/soil_map.h"
#include "terrain/tile_map.h"

namespace softsoil {

// How steep soil stands between two grid nodes.
struct SoilSlope {
  double repose;  // [-]  tangent of the angle of repose: loose soil
  double wall;    // [m]  besides, firm soil stands as a wall so high
};

class SoilSlopes {
 public:
  SoilSlopes(SoilSlope everywhere) : spacing_(0), slopes_{everywhere} {}
  // spacing [m] of the grid.
  SoilSlopes(const SoilMap& soils, double spacing);

  int size() const { return static_cast<int>(slopes_.size()); }
  const SoilSlope& operator[](int soil) const { return slopes_[soil]; }
  // The number of the soil at a node. Loose soil counts as the soil that it lies on.
  int SoilAt(GridNode node) const {
    return slopes_.size() == 1 ? 0 : soils_.NumberAt(node.i * spacing_, node.j * spacing_);
  }

 private:
  SoilMap soils_;
  double spacing_;
  std::vector<SoilSlope> slopes_;
};

}  // namespace softsoil
