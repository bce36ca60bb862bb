// Columns of soil as they are before any load: one profile per soil.
#pragma once

#include <vector>

#include "terrain/compaction.h"
#include "terrain/soil_map.h"
#include "terrain/tile_map.h"

namespace softsoil {

struct ColumnSettings {
  double spacing;        // [m]  of the grid, > 0
  double volume_height;  // [m]  initial height w of a volume, > 0
  int volumes;           // [-]  per column, > 0
};

struct ColumnProfile {
  std::vector<SoilVolume> volumes;  // from the top down
  double yield_stress;              // [Pa]  of the weakest of them
};

class ColumnProfiles {
 public:
  ColumnProfiles(const SoilMap& soils, const ColumnSettings& settings);

  const ColumnSettings& settings() const { return settings_; }
  // The number of the soil at a node.
  int SoilAt(GridNode node) const {
    return soils_.NumberAt(node.i * settings_.spacing, node.j * settings_.spacing);
  }
  const ColumnProfile& operator[](int soil) const { return profiles_[soil]; }
  const Compaction& CompactionOf(int soil) const { return soils_[soil].compaction; }
  // Mass [kg/m^2] of the volume k per area of its column; compaction does not change it.
  double VolumeMass(int soil, int k) const {
    return settings_.volume_height * profiles_[soil].volumes[k].density;
  }
  // Of the weakest soil, and of that in which a load reaches farthest.
  double least_yield_stress() const { return least_yield_stress_; }       // [Pa]
  double farthest_reaching_factor() const { return farthest_reaching_; }  // [-]  nu

 private:
  SoilMap soils_;
  ColumnSettings settings_;
  std::vector<ColumnProfile> profiles_;  // by soil
  double least_yield_stress_, farthest_reaching_;
};

}  // namespace softsoil
