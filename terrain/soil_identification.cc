#include "terrain/soil_identification.h"

#include "terrain/constants.h"
#include "terrain/input_error.h"
#include "terrain/pedotransfer.h"
#include "terrain/soil_findings.h"

namespace softsoil {
namespace {

// What each piece of evidence says of the soil.
class Identification : private SoilFindings {
 public:
  explicit Identification(const SoilEvidence& evidence)
      : SoilFindings(evidence.like), evidence_(evidence) {}

  IdentifiedSoil Result() {
    Indices();
    Bearing();
    Shear();
    Compaction();
    OfAnother("stress");
    Companions();
    return std::move(result_);
  }

 private:
  Finding Estimated(const std::string& result) const {
    const Estimate estimate = Apply(result, *evidence_.composition);
    return {result, estimate.value, "", 0, estimate.how, estimate.made_from, estimate.warning};
  }

  void Indices();
  void SetModulus(const char* name, const Fitted& modulus, bool is_held);
  void Bearing();
  void Shear();
  void Compaction();
  void VirginCurve();
  void Moisten();
  void InitialDensity();
  void Companions();

  const SoilEvidence& evidence_;
};

// As printed for a class, by relation from shares.
void Identification::Indices() {
  if (!evidence_.composition) return;
  const Composition& soil = *evidence_.composition;
  const UscsSoil* uscs = evidence_.uscs;
  result_.composition = InWords(soil.texture);
  if (uscs != nullptr) {
    result_.composition = std::string("USCS ") + uscs->name + ", " + result_.composition;
  }
  for (const auto& [name, value] : {std::pair("clay index", soil.clay_index),
                                    std::pair("grain size index", soil.grain_size_index)}) {
    Finding finding = Estimated(name);
    if (uscs != nullptr) finding = {name, value, "", 0, "printed", uscs->source, ""};
    Report(finding);
  }
}

void Identification::SetModulus(const char* name, const Fitted& modulus, bool is_held) {
  const auto& [fit, from, summary] = *evidence_.bearing;
  if (!is_held) return SetFitted("bearing", name, modulus, from);
  Set("bearing", name,
      {"", 0, "", 0, "held at 0", from,
       "the readings ask for " + Rounded(fit.free_value, 4) + "; fitted again without"});
}

void Identification::Bearing() {
  if (!evidence_.bearing) return OfAnother("bearing");
  const auto& [fit, from, summary] = *evidence_.bearing;
  const bool reece = fit.form == BearingForm::kReece;
  soil().bearing.form = fit.form;
  const char* cohesive = reece ? "k_1" : "k_c";
  const char* frictional = reece ? "k_2" : "k_phi";
  const bool one_width = fit.basis == ModuliFrom::kPlatesOfOneWidth;
  if (one_width && !evidence_.is_frictional) {
    result_.missing.emplace_back("bearing");
    Report({"bearing k_e", fit.frictional.value, "N/m^(n+2)", fit.frictional.confidence, "fit",
            from,
            "k_c/b + k_phi, for plates of " + Shown(fit.widths[0]) +
                " m alone: one width does not tell k_c from k_phi"});
  } else if (one_width) {
    Set("bearing", cohesive, {"", 0, "", 0, "assumed", "soil said to be frictional", ""});
    SetFitted("bearing", frictional, fit.frictional, from,
              "one plate, " + Shown(fit.widths[0]) + " m: holds for that width");
  } else {
    SetModulus(cohesive, fit.cohesive, fit.basis == ModuliFrom::kNoCohesive);
    SetModulus(frictional, fit.frictional, fit.basis == ModuliFrom::kNoFrictional);
    if (reece && HoldsZero(fit.cohesive) && HoldsZero(fit.frictional)) {
      result_.undetermined.insert(result_.undetermined.end(), {"bearing k_1", "bearing k_2"});
    }
  }
  SetFitted("bearing", "n", fit.exponent, from);
  SourceOf("bearing") = "least squares of plate-sinkage tests, " + summary;
}

void Identification::Shear() {
  if (!evidence_.shear && !evidence_.composition) {
    OfAnother("shear");
    const softsoil::Shear& shear = like_.shear;
    if (shear.form == ShearForm::kHumped)
      CompanionOfAnother("shear", "residual", shear.residual, "");
    return;
  }
  soil().shear = {};  // no hump
  if (!evidence_.shear) {
    Set("shear", "cohesion", Estimated("cohesion"));
    Set("shear", "friction_angle_deg", Estimated("friction angle"));
    Set("shear", "modulus", Estimated("shear modulus"));
    SourceOf("shear") = "relations fitted to soils of Madsen 2014, 3.3, at " + result_.composition;
    return;
  }
  const auto& [fit, from, summary] = *evidence_.shear;
  const auto held = [&fit = fit](StrengthBound bound, double factor) {
    if (fit.bound != bound) return std::string();
    return "held at 0: the readings ask for " + Rounded(fit.free_value / factor, 4) +
           "; fitted again without";
  };
  std::string curves = fit.is_short ? "the slip ends before 2 K: the strength is extrapolated" : "";
  if (fit.falls_after_peak) {
    curves += std::string(curves.empty() ? "" : "; ") +
              "the stress falls after its peak, which this law does not";
  }
  SetFitted("shear", "cohesion", fit.cohesion, from, held(StrengthBound::kNoCohesion, 1));
  SetFitted("shear", "friction_angle_deg", fit.friction_angle, from,
            held(StrengthBound::kNoFriction, 1 / kDegrees));
  SetFitted("shear", "modulus", fit.modulus, from, curves);
  SourceOf("shear") = "least squares of shear tests, " + summary;
}

void Identification::Compaction() {
  if (!evidence_.composition && evidence_.saturation) {
    throw InputError("a saturation needs the composition of the soil, which gives its slope");
  }
  if (!evidence_.composition && !evidence_.like) {
    if (evidence_.bulk_density) {
      throw InputError(
          "a bulk density alone gives no virgin curve: the composition of the soil or "
          "a similar soil must be known too");
    }
    result_.missing.emplace_back("compaction");
    return;
  }
  if (evidence_.composition) {
    VirginCurve();
  } else {
    OfAnother("compaction", {"index", "reference_density", "reference_stress", "rebound_index"});
    SourceOf("compaction") = AsOfAnother();
  }
  Moisten();
  InitialDensity();
  if (evidence_.composition && evidence_.like) {
    SourceOf("compaction") += "; times as of " + like_.name;
  }
  OfAnother("compaction", {"compression_time", "rebound_time"});
}

void Identification::VirginCurve() {
  soil().compaction.moisture_shift = 0;
  Set("compaction", "index", Estimated("compression index"));
  Finding density = Estimated("reference density");
  if (evidence_.uscs != nullptr && *evidence_.uscs->caution != '\0') {
    density.warning += (density.warning.empty() ? "" : "; ") + std::string(evidence_.uscs->caution);
  }
  Set("compaction", "reference_density", density);
  Set("compaction", "reference_stress",
      {"", kReferenceStress, "", 0, "printed", "Madsen 2014, 3.3", ""});
  Set("compaction", "rebound_index", Estimated("rebound index"));
  SourceOf("compaction") = "relations of Madsen 2014, 3.3 (rebound index: equation 3.9; others " +
                           std::string("fitted to soils printed there), at ") + result_.composition;
}

void Identification::Moisten() {
  if (!evidence_.saturation) return;
  const auto [actual, reference] = *evidence_.saturation;
  for (double share : {actual, reference}) {
    if (share >= 0 && share <= 1) continue;
    throw InputError("a saturation must be 0 to 1, got " + Shown(share));
  }
  Finding slope = Estimated("moisture slope");
  result_.entry.moisture = {slope.value, actual, reference};
  soil().compaction.moisture_shift = slope.value * (actual - reference);
  slope.parameter = "moisture slope";
  slope.unit = "kg/m^3";
  Report(slope);
  Report({"moisture shift", soil().compaction.moisture_shift, "kg/m^3", 0, "equation 3.5",
          "saturation " + Shown(actual) + ", reference " + Shown(reference), ""});
  SourceOf("moisture") =
      "slope: line through CH and ML of Madsen 2014, 3.3, at " + result_.composition;
}

void Identification::InitialDensity() {
  softsoil::Compaction& compaction = soil().compaction;
  const double virgin = compaction.reference_density + compaction.moisture_shift;
  const std::string stress = Shown(compaction.reference_stress / 1e3) + " kPa";
  if (evidence_.bulk_density) {
    constexpr double kQuartz = 2650;  // [kg/m^3]
    constexpr double kLoosest = 300;  // [kg/m^3]  looser than any mineral soil: g/cm^3 is caught
    const double density = *evidence_.bulk_density;
    if (!(density >= kLoosest && density < kQuartz)) {
      throw InputError(
          "the bulk density must be 300 kg/m^3 to below 2650 kg/m^3, the density of "
          "quartz, got " +
          Shown(density) + " kg/m^3");
    }
    const double least = LeastInitialDensity(compaction);
    if (density < least) {
      throw InputError("the bulk density must be >= " + Rounded(least, 6) +
                       " kg/m^3, where the virgin curve has 100 Pa, got " + Shown(density) +
                       " kg/m^3");
    }
    Set("compaction", "initial_density", {"", density, "", 0, "measured", "bulk density", ""});
    SourceOf("compaction") += "; initial density measured";
  } else if (evidence_.composition) {
    Set("compaction", "initial_density",
        {"", virgin, "", 0, "assumed", "never loaded beyond " + stress,
         "no bulk density was given"});
    SourceOf("compaction") +=
        "; initial density not measured, taken as never loaded beyond " + stress;
  } else {
    OfAnother("compaction", {"initial_density"});
    soil().layers = like_.layers;
  }
  Report({"preconsolidation stress", VirginStress(compaction, compaction.initial_density), "Pa", 0,
          "virgin curve", "initial density", ""});
}

// What a soil may have besides, which another soil alone gives.
void Identification::Companions() {
  const auto& [k_0, A_u] = soil().unloading;
  if (!soil().unloading.IsRigid()) {
    CompanionOfAnother("unloading", "k_0", k_0, "Pa/m");
    CompanionOfAnother("unloading", "A_u", A_u, "Pa/m^2");
  }
  for (const DensityLayer& layer : soil().layers) {
    CompanionOfAnother("layers", "initial_density below " + Shown(layer.top) + " m", layer.density,
                       "kg/m^3");
  }
  if (!soil().max_stress) return;
  CompanionOfAnother("max_stress", "c_1", soil().max_stress->c_1, "");
  CompanionOfAnother("max_stress", "c_2", soil().max_stress->c_2, "");
}

}  // namespace

IdentifiedSoil Identify(const SoilEvidence& evidence) { return Identification(evidence).Result(); }

}  // namespace softsoil
