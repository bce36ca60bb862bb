// A loose loam for tests: it yields at its reference stress, 96 kPa.
#pragma once

#include "terrain/soil.h"

namespace softsoil {

inline Compaction LooseLoam() {
  Compaction soil{};
  soil.index = 500;
  soil.reference_density = 1200;
  soil.reference_stress = 96e3;
  soil.initial_density = 1200;
  soil.rebound_index = 20;
  soil.compression_time = 0.2;
  soil.rebound_time = 0.004;
  soil.moisture_shift = 0;
  return soil;
}

inline Soil LooseSoil() {
  Soil soil{};
  soil.name = "loose";
  soil.bearing = {6800, 1134e3, 0.85};
  soil.shear = {7100, 0.37, 0.0106};
  soil.compaction = LooseLoam();
  soil.concentration_factor = 5;
  return soil;
}

}  // namespace softsoil
