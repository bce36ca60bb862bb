#include "terrain/soil_slopes.h"

#include <cmath>

#include "terrain/repose.h"

namespace softsoil {

SoilSlopes::SoilSlopes(const SoilMap& soils, double spacing) : soils_(soils), spacing_(spacing) {
  for (int k = 0; k < soils.size(); ++k) {
    const Soil& soil = soils[k];
    const double gamma = kGravity * soil.compaction.initial_density;
    slopes_.push_back({std::tan(AngleOfRepose(soil)), CriticalHeight(soil.shear, gamma, kPi / 2)});
  }
}

}  // namespace softsoil
