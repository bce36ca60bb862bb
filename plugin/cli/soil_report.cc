#include "plugin/cli/soil_report.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <vector>

namespace softsoil {
namespace {

using Json = nlohmann::ordered_json;
using Row = std::array<std::string, 5>;

std::string ValueOf(const Finding& finding) {
  std::string text = Rounded(finding.value, 4);
  if (std::isinf(finding.confidence))
    text += " +- unknown";
  else if (finding.confidence > 0)
    text += " +- " + Rounded(finding.confidence, 2);
  return text;
}

std::string Joined(const Row& row, const std::array<std::size_t, 5>& widths) {
  std::string line;
  for (std::size_t c = 0; c < row.size(); ++c) {
    line += row[c] + std::string(c + 1 < row.size() ? widths[c] - row[c].size() + 2 : 0, ' ');
  }
  return line + "\n";
}

Json FindingAsJson(const Finding& finding) {
  Json json = {{"parameter", finding.parameter}, {"value", finding.value}, {"unit", finding.unit}};
  if (std::isfinite(finding.confidence) && finding.confidence > 0) {
    json["confidence_95"] = finding.confidence;
  }
  json["how"] = finding.how;
  json["made_from"] = finding.made_from;
  if (!finding.warning.empty()) json["warning"] = finding.warning;
  return json;
}

Json PlateAsJson(const PlateSinkage& test, const BearingFit& fit) {
  return {{"form", fit.form == BearingForm::kReece ? "reece" : "bekker"},
          {"width", test.width},
          {"sinkage", test.sinkage},
          {"pressure", test.pressure},
          {"fitted", fit.fitted},
          {"cohesive", fit.cohesive.value},
          {"frictional", fit.frictional.value},
          {"n", fit.exponent.value},
          {"rms", fit.rms}};
}

Json ShearAsJson(const ShearTest& test, const ShearFit& fit) {
  return {{"normal_stress", test.normal_stress}, {"displacement", test.displacement},
          {"shear_stress", test.shear_stress},   {"fitted", fit.fitted},
          {"cohesion", fit.cohesion.value},      {"friction_angle", fit.friction_angle.value},
          {"modulus", fit.modulus.value},        {"rms", fit.rms}};
}

}  // namespace

std::string TableOf(const IdentifiedSoil& soil, const SoilEvidence& evidence) {
  std::vector<Row> rows = {{"parameter", "value", "unit", "how", "made from"}};
  std::string warnings;
  for (const Finding& f : soil.findings) {
    const std::string how = f.how + (f.confidence > 0 ? ", 95 %" : "");
    rows.push_back({f.parameter, ValueOf(f), f.unit, how, f.made_from});
    if (!f.warning.empty()) warnings += "  " + f.parameter + ": " + f.warning + "\n";
  }
  std::array<std::size_t, 5> widths{};
  for (const Row& row : rows) {
    for (std::size_t c = 0; c < row.size(); ++c) widths[c] = std::max(widths[c], row[c].size());
  }
  std::string text;
  if (!soil.composition.empty()) text += "composition: " + soil.composition + "\n\n";
  for (const Row& row : rows) text += Joined(row, widths);
  if (!warnings.empty()) text += "\nwarnings\n" + warnings;
  if (evidence.bearing || evidence.shear) text += "\ntests\n";
  if (evidence.bearing) text += "  " + evidence.bearing->summary + "\n";
  if (evidence.shear) text += "  " + evidence.shear->summary + "\n";
  return text;
}

std::string JsonOf(const IdentifiedSoil& soil, const SoilEvidence& evidence,
                   const SoilTests& tests) {
  Json json;
  json["name"] = soil.entry.soil.name;
  for (const Finding& finding : soil.findings) json["findings"].push_back(FindingAsJson(finding));
  if (tests.plate) json["plate"] = PlateAsJson(*tests.plate, evidence.bearing->fit);
  if (tests.shear) json["shear"] = ShearAsJson(*tests.shear, evidence.shear->fit);
  return json.dump(1) + "\n";
}

}  // namespace softsoil
