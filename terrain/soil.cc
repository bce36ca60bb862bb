#include "terrain/soil.h"

#include <algorithm>
#include <cmath>

#include "terrain/repose.h"

namespace softsoil {

namespace {

using Table = std::vector<Attribute<Soil>>;
using R = Range;

Table BearingAttributes(BearingForm form) {
  if (form == BearingForm::kReece) {
    return {
        {"bearing", "k_1", "Pa", 1, R::kNotNegative, "cohesive modulus c k'_c (Reece)",
         [](Soil& s) -> double& { return s.bearing.k_c; }},
        {"bearing", "k_2", "Pa/m", 1, R::kNotNegative, "frictional modulus gamma k'_phi (Reece)",
         [](Soil& s) -> double& { return s.bearing.k_phi; }}};
  }
  return {{"bearing", "k_c", "N/m^(n+1)", 1, R::kNotNegative, "cohesive modulus (Bekker)",
           [](Soil& s) -> double& { return s.bearing.k_c; }},
          {"bearing", "k_phi", "N/m^(n+2)", 1, R::kPositive, "frictional modulus (Bekker)",
           [](Soil& s) -> double& { return s.bearing.k_phi; }}};
}

Table CommonAttributes() {
  return {
      {"bearing", "n", "", 1, R::kPositive, "sinkage exponent",
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
}

Table SoilTable(BearingForm form) {
  Table table = BearingAttributes(form);
  for (const Attribute<Soil>& attribute : CommonAttributes()) table.push_back(attribute);
  return table;
}

// rho_S = S_T (S_1 - S_0) of equation 3.5; the element may be left out.
double MoistureShift(XmlEntry& entry) {
  if (!entry.Has("moisture")) return 0.0;
  const double slope = entry.Number("moisture", "slope", "kg/m^3", Range::kAny);
  const double actual = entry.Number("moisture", "saturation", "", Range::kUpToOne);
  const double reference = entry.Number("moisture", "reference_saturation", "", Range::kUpToOne);
  return slope * (actual - reference);
}

// The stress [Pa] of a centimetre of soil. None is looser than its own weight makes it; and loads
// would compact it as far as the eye sees.
constexpr double kLeastYieldStress = 100;

void RefuseTooLoose(const XmlEntry& entry, const Compaction& soil, double density) {
  if (VirginStress(soil, density) >= kLeastYieldStress) return;
  entry.Refuse("initial_density must be >= " + Shown(LeastInitialDensity(soil)) +
               " kg/m^3, where the virgin curve has 100 Pa, got " + Shown(density));
}

void ReadBearing(XmlEntry& entry, Soil* soil) {
  const bool reece =
      entry.Has("bearing", "form") && entry.Text("bearing", "form", {"bekker", "reece"}) == "reece";
  soil->bearing.form = reece ? BearingForm::kReece : BearingForm::kBekker;
  entry.Fill(SoilAttributes(soil->bearing.form), *soil);
  if (soil->bearing.k_c == 0 && soil->bearing.k_phi == 0) {
    entry.Refuse("one of k_1 and k_2 must be > 0");
  }
}

void ReadShearForm(XmlEntry& entry, Shear* shear) {
  if (!entry.Has("shear", "form")) return;
  if (entry.Text("shear", "form", {"janosi_hanamoto", "humped"}) != "humped") return;
  shear->form = ShearForm::kHumped;
  shear->residual = entry.Number("shear", "residual", "", Range::kUpToOne);
}

std::optional<double> ReadAngleOfRepose(XmlEntry& entry, const Soil& soil) {
  if (!entry.Has("shear", "angle_of_repose_deg")) return std::nullopt;
  const double angle =
      entry.Number("shear", "angle_of_repose_deg", "deg", Range::kUpTo90Degrees) * kPi / 180;
  const double gamma = kGravity * soil.compaction.initial_density;
  const double steepest = SteepestHeap(soil.shear, gamma, kHighestHeap);
  if (angle < kLeastRepose || angle > steepest) {
    entry.Refuse("angle_of_repose_deg must be " + Shown(kLeastRepose * kDegrees) + " to " +
                 Rounded(steepest * kDegrees, 4) +
                 " deg, at which friction and cohesion hold a heap 1 m high, got " +
                 Rounded(angle * kDegrees, 7));
  }
  return angle;
}

double ReadSlipSinkage(XmlEntry& entry) {
  if (!entry.Has("shear", "slip_sinkage")) return 0.0;
  const double slip_sinkage = entry.Number("shear", "slip_sinkage", "", Range::kNotNegative);
  if (slip_sinkage > kMostSlipSinkage) {
    entry.Refuse("slip_sinkage must be 0 to " + Shown(kMostSlipSinkage) + ", got " +
                 Shown(slip_sinkage));
  }
  return slip_sinkage;
}

Unloading ReadUnloading(XmlEntry& entry) {
  if (!entry.Has("unloading")) return {};
  const Unloading unloading{entry.Number("unloading", "k_0", "Pa/m", Range::kNotNegative),
                            entry.Number("unloading", "A_u", "Pa/m^2", Range::kNotNegative)};
  if (unloading.k_0 == 0 && unloading.A_u == 0) entry.Refuse("one of k_0 and A_u must be > 0");
  return unloading;
}

std::vector<DensityLayer> ReadLayers(XmlEntry& entry) {
  if (!entry.Has("layers")) return {};
  const auto tops = entry.Numbers("layers", "top", "m", Range::kPositive);
  const auto densities = entry.Numbers("layers", "initial_density", "kg/m^3", Range::kPositive);
  if (tops.size() != densities.size()) {
    entry.Refuse("top and initial_density of <layers> must be as many numbers, got " +
                 std::to_string(tops.size()) + " and " + std::to_string(densities.size()));
  }
  std::vector<DensityLayer> layers;
  for (std::size_t i = 0; i < tops.size(); ++i) {
    if (i > 0 && tops[i] <= tops[i - 1]) {
      entry.Refuse("top of <layers> must rise, got " + Shown(tops[i]) + " m after " +
                   Shown(tops[i - 1]) + " m");
    }
    layers.push_back({tops[i], densities[i]});
  }
  return layers;
}

std::optional<MaxStress> ReadMaxStress(XmlEntry& entry) {
  if (!entry.Has("max_stress")) return std::nullopt;
  return MaxStress{entry.Number("max_stress", "c_1", "", Range::kUpToOne),
                   entry.Number("max_stress", "c_2", "", Range::kUpToOne)};
}

Soil ReadSoil(XmlEntry& entry) {
  Soil soil{};
  soil.name = entry.name();
  soil.description = entry.description();
  ReadBearing(entry, &soil);
  ReadShearForm(entry, &soil.shear);
  soil.unloading = ReadUnloading(entry);
  soil.compaction.moisture_shift = MoistureShift(entry);
  soil.layers = ReadLayers(entry);
  soil.max_stress = ReadMaxStress(entry);
  soil.angle_of_repose = ReadAngleOfRepose(entry, soil);
  soil.slip_sinkage = ReadSlipSinkage(entry);
  RefuseTooLoose(entry, soil.compaction, soil.compaction.initial_density);
  for (const DensityLayer& layer : soil.layers) {
    RefuseTooLoose(entry, soil.compaction, layer.density);
  }
  return soil;
}

}  // namespace

const std::vector<Attribute<Soil>>& SoilAttributes(BearingForm form) {
  static const Table bekker = SoilTable(BearingForm::kBekker);
  static const Table reece = SoilTable(BearingForm::kReece);
  return form == BearingForm::kReece ? reece : bekker;
}

double AngleOfRepose(const Soil& soil) {
  return soil.angle_of_repose.value_or(std::max(soil.shear.friction_angle, kLeastRepose));
}

double LeastInitialDensity(const Compaction& soil) {
  return soil.reference_density + soil.moisture_shift +
         soil.index * std::log10(kLeastYieldStress / soil.reference_stress);
}

double InitialDensity(const Soil& soil, double depth) {
  double density = soil.compaction.initial_density;
  for (const DensityLayer& layer : soil.layers) {
    if (depth >= layer.top) density = layer.density;
  }
  return density;
}

double UnitWeight(const Soil& soil) { return kGravity * InitialDensity(soil, 0); }

Catalogue<Soil> SoilCatalogue() { return {"soil", ReadSoil}; }

}  // namespace softsoil
