#include "plugin/cli/soil_identify.h"

#include <cstdio>
#include <filesystem>
#include <map>
#include <vector>

#include "plugin/cli/catalogues.h"
#include "plugin/cli/entry_output.h"
#include "plugin/cli/picture.h"
#include "plugin/cli/soil_report.h"
#include "plugin/cli/standard_output.h"
#include "terrain/input_error.h"

namespace softsoil {
namespace {

namespace fs = std::filesystem;

// Given all together or not at all.
bool AreGiven(const std::vector<std::pair<const char*, std::optional<double>>>& options) {
  std::string given, missing;
  for (const auto& [name, value] : options) {
    std::string& list = value ? given : missing;
    list += (list.empty() ? "" : ", ") + std::string(name);
  }
  if (!given.empty() && !missing.empty()) throw InputError(given + " needs " + missing + " too");
  return missing.empty();
}

void AddComposition(const SoilOptions& options, SoilEvidence* evidence) {
  const bool shares =
      AreGiven({{"--clay", options.clay}, {"--silt", options.silt}, {"--sand", options.sand}});
  if (options.uscs && shares)
    throw InputError("--uscs and --clay, --silt, --sand exclude one another");
  if (options.uscs) {
    evidence->uscs = &FindUscsSoil(*options.uscs);
    evidence->composition = evidence->uscs->composition;
  } else if (shares) {
    evidence->composition = CompositionOf({*options.clay, *options.silt, *options.sand});
  }
}

void AddState(const SoilOptions& options, SoilEvidence* evidence) {
  evidence->bulk_density = options.bulk_density;
  if (AreGiven({{"--saturation", options.saturation},
                {"--reference-saturation", options.reference_saturation}})) {
    evidence->saturation = {*options.saturation, *options.reference_saturation};
  }
  if (options.like) {
    const Catalogue<Soil> soils = SoilsWith(options.soil_files);
    evidence->like = At("--like", [&] { return soils.Find(*options.like); });
  } else if (!options.soil_files.empty()) {
    throw InputError("--soil-file holds soils for --like: give --like too");
  }
}

// "tests.csv: 40 rows, width 0.05, 0.3 m, rms residual 2100 Pa"
template <class Fit>
Tested<Fit> Summarised(const std::string& path, const Fit& fit, const std::string& kind,
                       const std::vector<double>& values, const std::string& unit) {
  std::vector<std::string> words;
  for (double value : values) words.push_back(Rounded(value, 4));
  const std::string file = fs::path(path).filename().string();
  return {fit, file,
          file + ": " + std::to_string(fit.fitted.size()) + " rows, " + kind + " " + Listed(words) +
              " " + unit + ", rms residual " + Rounded(fit.rms, 3) + " Pa"};
}

SoilTests AddTests(const SoilOptions& options, SoilEvidence* evidence) {
  SoilTests tests;
  if (options.plate) {
    tests.plate = ReadPlateSinkage(*options.plate);
    const BearingForm form = options.reece ? BearingForm::kReece : BearingForm::kBekker;
    const BearingFit fit = At(*options.plate, [&] { return FitBearing(*tests.plate, form); });
    evidence->bearing = Summarised(*options.plate, fit, "width", fit.widths, "m");
    if (options.frictional && fit.basis != ModuliFrom::kPlatesOfOneWidth) {
      throw InputError("--frictional is for plates of one width, got " +
                       std::to_string(fit.widths.size()) + " widths, which tell k_c");
    }
    evidence->is_frictional = options.frictional;
  } else if (options.reece || options.frictional) {
    throw InputError(std::string(options.reece ? "--reece" : "--frictional") +
                     " says how to read a plate-sinkage test: give --plate too");
  }
  if (options.shear) {
    tests.shear = ReadShearTest(*options.shear);
    const ShearFit fit = At(*options.shear, [&] { return FitShear(*tests.shear); });
    evidence->shear = Summarised(*options.shear, fit, "normal stress", fit.normal_stresses, "Pa");
  }
  return tests;
}

// What would give each element that is missing.
std::string Remedies(const SoilEvidence& evidence, const std::vector<std::string>& missing,
                     const char* separator = "; ") {
  const std::map<std::string, std::string> remedies = {
      {"bearing", evidence.bearing ? "a second plate width, or --frictional to take k_c = 0"
                                   : "--plate FILE or --like SOIL"},
      {"shear", "--shear FILE, --uscs, --clay --silt --sand or --like SOIL"},
      {"compaction", evidence.composition ? "--like SOIL, for its times"
                                          : "--uscs or --clay --silt --sand, and --like SOIL"},
      {"stress", "--like SOIL"}};
  std::string text;
  for (const std::string& element : missing) {
    text += (text.empty() ? "" : separator) + ("<" + element + "> needs ") + remedies.at(element);
  }
  return text;
}

void RequireName(const SoilOptions& options) {
  std::vector<std::string> taken;
  const Catalogue<Soil> soils = SoilsWith(options.soil_files);
  for (const Soil& known : soils.entries()) taken.push_back(known.name);
  RequireEntryName(options.name, "soil", taken);
}

std::vector<std::string> Inputs(const SoilOptions& options) {
  std::vector<std::string> files = options.soil_files;
  for (const auto& file : {options.plate, options.shear}) {
    if (file) files.push_back(*file);
  }
  return files;
}

void RequireComplete(const SoilOptions& options, const SoilEvidence& evidence,
                     const IdentifiedSoil& soil) {
  if (soil.findings.empty()) {
    throw InputError(
        "nothing is known of the soil: give --uscs, --clay --silt --sand, --plate, "
        "--shear or --like");
  }
  if (!options.out) return;
  RequireName(options);
  if (!soil.missing.empty()) {
    throw InputError("the entry is incomplete: " + Remedies(evidence, soil.missing));
  }
  if (!soil.undetermined.empty()) {
    throw InputError("the readings do not determine " + Listed(soil.undetermined) +
                     ": the 95 % interval holds 0; --out needs readings with less scatter, deeper "
                     "or farther, or of more different plates or normal stresses");
  }
}

void Print(const SoilEvidence& evidence, const IdentifiedSoil& soil) {
  std::printf("%s", TableOf(soil, evidence).c_str());
  if (soil.missing.empty()) return;
  std::printf("\nmissing for an entry, --out\n  %s\n",
              Remedies(evidence, soil.missing, "\n  ").c_str());
}

}  // namespace

void IdentifySoil(const SoilOptions& options) {
  SoilEvidence evidence;
  AddComposition(options, &evidence);
  AddState(options, &evidence);
  const SoilTests tests = AddTests(options, &evidence);
  IdentifiedSoil soil = Identify(evidence);
  soil.entry.soil.name = options.name;
  RequirePlainText("--description", options.description);
  soil.entry.soil.description = options.description;
  RequireComplete(options, evidence, soil);
  const bool is_tested = options.plate || options.shear;
  if (options.picture && !is_tested) throw InputError("--picture needs --plate or --shear");
  const EntryFiles files =
      EntryFilesOf({options.out, options.picture, options.no_picture}, is_tested);
  const std::string python = files.picture.empty() ? "" : PythonThatPlots();
  PrepareEntryFiles(files, options.force, Inputs(options));

  Print(evidence, soil);
  const std::string entry = files.xml.empty() ? "" : SoilXml(soil.entry);
  WriteEntryFiles(files, {entry, JsonOf(soil, evidence, tests)}, python, "soil_tests.py");
  FlushStandardOutput();
}

}  // namespace softsoil
