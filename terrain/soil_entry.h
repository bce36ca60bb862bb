// Writes a soil as an entry of the catalogue.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "terrain/soil.h"

namespace softsoil {

// <moisture>: moves the virgin curve by slope * (saturation - reference_saturation).
struct Moisture {
  double slope;                 // [kg/m^3 per unit of saturation]
  double saturation;            // [-]  0 to 1
  double reference_saturation;  // [-]  0 to 1
};

struct SoilEntry {
  Soil soil;
  std::optional<Moisture> moisture;           // of which soil.compaction.moisture_shift is made
  std::map<std::string, std::string> source;  // of each element, "bearing"
};

// The text of a soil file with this entry alone, numbers with seven digits. Every element that the
// soil needs must have a source.
std::string SoilXml(const SoilEntry& entry);

// A number as a file or a table shows it: so many significant digits.
std::string Rounded(double value, int digits);

}  // namespace softsoil
