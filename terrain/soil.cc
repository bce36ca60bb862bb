#include "terrain/soil.h"

#include <cmath>

#include "terrain/constants.h"

namespace softsoil {

const std::vector<Attribute<Soil>>& SoilAttributes() {
  using R = Range;
  static const std::vector<Attribute<Soil>> table = {
      {"bearing", "k_c", "N/m^(n+1)", 1, R::kNotNegative, "cohesive modulus (Bekker)",
       [](Soil& s) -> double& { return s.bearing.k_c; }},
      {"bearing", "k_phi", "N/m^(n+2)", 1, R::kPositive, "frictional modulus (Bekker)",
       [](Soil& s) -> double& { return s.bearing.k_phi; }},
      {"bearing", "n", "", 1, R::kPositive, "sinkage exponent (Bekker)",
       [](Soil& s) -> double& { return s.bearing.n; }},
      {"shear", "cohesion", "Pa", 1, R::kNotNegative, "cohesion (Mohr-Coulomb)",
       [](Soil& s) -> double& { return s.shear.cohesion; }},
      {"shear", "friction_angle_deg", "deg", kPi / 180, R::kUpTo90Degrees,
       "angle of internal friction (Mohr-Coulomb)",
       [](Soil& s) -> double& { return s.shear.friction_angle; }},
      {"shear", "modulus", "m", 1, R::kPositive, "shear deformation modulus K (Janosi-Hanamoto)",
       [](Soil& s) -> double& { return s.shear.modulus; }},
      {"compaction", "index", "kg/m^3", 1, R::kPositive,
       "compression index C: density gained per decade of stress",
       [](Soil& s) -> double& { return s.compaction.index; }},
      {"compaction", "reference_density", "kg/m^3", 1, R::kPositive,
       "density on the virgin curve at the reference stress",
       [](Soil& s) -> double& { return s.compaction.reference_density; }},
      {"compaction", "reference_stress", "Pa", 1, R::kPositive, "a stress on the virgin curve",
       [](Soil& s) -> double& { return s.compaction.reference_stress; }},
      {"compaction", "initial_density", "kg/m^3", 1, R::kPositive,
       "density of the undisturbed soil",
       [](Soil& s) -> double& { return s.compaction.initial_density; }},
      {"compaction", "rebound_index", "kg/m^3", 1, R::kNotNegative,
       "most density that a load cycle gives back",
       [](Soil& s) -> double& { return s.compaction.rebound_index; }},
      {"compaction", "compression_time", "s", 1, R::kPositive, "time constant of compression",
       [](Soil& s) -> double& { return s.compaction.compression_time; }},
      {"compaction", "rebound_time", "s", 1, R::kPositive, "time constant of rebound",
       [](Soil& s) -> double& { return s.compaction.rebound_time; }},
      {"stress", "concentration_factor", "", 1, R::kConcentration,
       "Froehlich's concentration factor: 3 elastic, 6 very soft",
       [](Soil& s) -> double& { return s.concentration_factor; }},
  };
  return table;
}

namespace {

// rho_S = S_T (S_1 - S_0) of equation 3.5; the element may be left out.
double MoistureShift(XmlEntry& entry) {
  if (!entry.Has("moisture")) return 0.0;
  const double slope = entry.Number("moisture", "slope", "kg/m^3", Range::kAny);
  const double actual = entry.Number("moisture", "saturation", "", Range::kNotNegative);
  const double reference =
      entry.Number("moisture", "reference_saturation", "", Range::kNotNegative);
  return slope * (actual - reference);
}

// The stress [Pa] of a centimetre of soil. None is looser than its own weight makes it; and loads
// would compact it as far as the eye sees.
constexpr double kLeastYieldStress = 100;

void RefuseTooLoose(const XmlEntry& entry, const Compaction& soil) {
  if (VirginStress(soil, soil.initial_density) >= kLeastYieldStress) return;
  const double least = soil.reference_density + soil.moisture_shift +
                       soil.index * std::log10(kLeastYieldStress / soil.reference_stress);
  entry.Refuse("initial_density must be >= " + Shown(least) +
               " kg/m^3, where the virgin curve has 100 Pa, got " + Shown(soil.initial_density));
}

Soil ReadSoil(XmlEntry& entry) {
  Soil soil{};
  soil.name = entry.name();
  soil.description = entry.description();
  entry.Fill(SoilAttributes(), soil);
  soil.compaction.moisture_shift = MoistureShift(entry);
  RefuseTooLoose(entry, soil.compaction);
  return soil;
}

}  // namespace

Catalogue<Soil> SoilCatalogue() { return {"soil", ReadSoil}; }

}  // namespace softsoil
