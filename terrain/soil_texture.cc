#include "terrain/soil_texture.h"

#include <algorithm>
#include <cmath>

#include "terrain/input_error.h"
#include "terrain/limits.h"
#include "terrain/pedotransfer.h"

namespace softsoil {
namespace {

struct Share {
  const char* name;
  double Texture::*value;
};
constexpr Share kShares[] = {
    {"clay", &Texture::clay}, {"silt", &Texture::silt}, {"sand", &Texture::sand}};

// What the soils of the thesis span.
Limits DataOf(const Share& share) {
  const auto [least, most] = std::minmax_element(
      UscsSoils().begin(), UscsSoils().end(), [&](const UscsSoil& a, const UscsSoil& b) {
        return a.composition.texture.*share.value < b.composition.texture.*share.value;
      });
  return {least->composition.texture.*share.value, most->composition.texture.*share.value};
}

void RequireWhole(const Texture& texture) {
  for (const Share& share : kShares) {
    const double value = texture.*share.value;
    if (value >= 0 && std::isfinite(value)) continue;
    throw InputError(std::string(share.name) + " must be >= 0 %, got " + Shown(value) + " %");
  }
  constexpr double kTolerance = 0.2 + 1e-9;  // [%]  three roundings to 0.1 and floating point
  const double sum = texture.clay + texture.silt + texture.sand;
  if (std::abs(sum - 100) <= kTolerance) return;
  throw InputError("clay, silt and sand must add up to 100 % (within 0.2 %), got " +
                   Shown(std::round(sum * 1e6) / 1e6) + " %");
}

void RequireWithinData(const Texture& texture) {
  for (const Share& share : kShares) {
    const Limits data = DataOf(share);
    if (Contains(data, texture.*share.value)) continue;
    throw InputError(std::string(share.name) + " must be " + InWords(data) +
                     " %, the range of the soils behind the relations (Madsen 2014: CH, ML, SW, " +
                     "CL, MH), got " + Shown(texture.*share.value) +
                     " %; test the soil (--plate, --shear) or name a similar one (--like)");
  }
}

}  // namespace

const std::vector<UscsSoil>& UscsSoils() {
  using R = RatingConeIndex;
  static const std::vector<UscsSoil> soils = {
      {"CH", {{73.3, 13.3, 13.4}, 5.0, 5.0, R::k80}, "Madsen 2014, 3.3", ""},
      {"ML", {{13.6, 61.5, 24.9}, 0.93, 2.63, R::k80}, "Madsen 2014, 3.3", ""},
      {"SW",
       {{6.9, 2.3, 90.8}, 0.47, 0.75, R::k80},
       "Madsen 2014, 3.3",
       "the row printed for SW (Table 3.1, row 3) repeats that of CH and tells nothing of it"},
      {"CL", {{47.1, 24.0, 28.9}, 3.21, 2.32, R::kYoloLoam}, "Madsen 2014, 6.1.1", ""},
      {"MH",
       {{34.8, 50.0, 15.2}, 2.38, 4.27, R::kYoloLoam},
       "Madsen 2014, 6.1.2",
       "6.1.2 prints a density of 1200 kg/m^3 at 98.1 kPa, off the relation"},
  };
  return soils;
}

const UscsSoil& FindUscsSoil(const std::string& name) {
  std::vector<std::string> known;
  for (const UscsSoil& soil : UscsSoils()) {
    if (soil.name == name) return soil;
    known.push_back(soil.name);
  }
  throw InputError("unknown USCS class \"" + name + "\"; there are data for: " + Listed(known));
}

Composition CompositionOf(const Texture& texture) {
  RequireWhole(texture);
  RequireWithinData(texture);
  return {texture, ClayIndex(texture), GrainSizeIndex(MeanGrainSize(texture)),
          RatingConeIndex::k80};
}

std::string InWords(const Texture& texture) {
  return Shown(texture.clay) + " % clay, " + Shown(texture.silt) + " % silt, " +
         Shown(texture.sand) + " % sand";
}

}  // namespace softsoil
