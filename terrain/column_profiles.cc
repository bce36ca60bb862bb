#include "terrain/column_profiles.h"

#include <algorithm>
#include <limits>

#include "terrain/point_load.h"

namespace softsoil {
namespace {

ColumnProfile ProfileOf(const Soil& soil, const ColumnSettings& settings) {
  ColumnProfile profile{{}, std::numeric_limits<double>::infinity()};
  for (int k = 0; k < settings.volumes; ++k) {
    const double middle = (k + 0.5) * settings.volume_height;
    profile.volumes.push_back(UndisturbedVolume(soil.compaction, InitialDensity(soil, middle)));
    profile.yield_stress =
        std::min(profile.yield_stress, profile.volumes.back().preconsolidation_stress);
  }
  return profile;
}

}  // namespace

ColumnProfiles::ColumnProfiles(const SoilMap& soils, const ColumnSettings& settings)
    : soils_(soils),
      settings_(settings),
      least_yield_stress_(std::numeric_limits<double>::infinity()),
      farthest_reaching_(soils[0].concentration_factor) {
  for (int k = 0; k < soils.size(); ++k) {
    profiles_.push_back(ProfileOf(soils[k], settings));
    least_yield_stress_ = std::min(least_yield_stress_, profiles_[k].yield_stress);
    const double nu = soils[k].concentration_factor;
    if (FroehlichReach(nu) > FroehlichReach(farthest_reaching_)) farthest_reaching_ = nu;
  }
}

}  // namespace softsoil
