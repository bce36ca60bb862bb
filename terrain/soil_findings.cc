#include "terrain/soil_findings.h"

#include <algorithm>

namespace softsoil {
namespace {

constexpr char kAsOfAnother[] = "as of another";

const Attribute<Soil>& Find(BearingForm form, const std::string& element, const std::string& name) {
  const auto& table = SoilAttributes(form);
  return *std::find_if(table.begin(), table.end(), [&](const Attribute<Soil>& a) {
    return a.element == element && a.name == name;
  });
}

}  // namespace

SoilFindings::SoilFindings(const std::optional<Soil>& like) : has_like_(like) {
  if (!like) return;
  like_ = *like;
  // The catalogue says how far moisture moves the curve, not by which slope and saturation.
  like_.compaction.reference_density += like_.compaction.moisture_shift;
  like_.compaction.moisture_shift = 0;
  soil() = like_;
  soil().layers.clear();
}

void SoilFindings::Set(const std::string& element, const std::string& name, Finding finding) {
  const Attribute<Soil>& a = Find(soil().bearing.form, element, name);
  a.field(soil()) = finding.value * a.to_si;
  finding.parameter = element + " " + name;
  finding.unit = a.unit;
  Report(std::move(finding));
}

void SoilFindings::SetFitted(const std::string& element, const std::string& name,
                             const Fitted& fitted, const std::string& from, std::string warning) {
  const Attribute<Soil>& a = Find(soil().bearing.form, element, name);
  if (HoldsZero(fitted)) {
    warning += std::string(warning.empty() ? "" : "; ") + "the readings hardly determine it";
    if (a.range == Range::kPositive) result_.undetermined.push_back(element + " " + name);
  }
  Set(element, name,
      {"", fitted.value / a.to_si, "", fitted.confidence / a.to_si, "fit", from, warning});
}

void SoilFindings::OfAnother(const std::string& element, const std::vector<std::string>& names) {
  if (!has_like_) {
    auto& missing = result_.missing;
    if (missing.empty() || missing.back() != element) missing.push_back(element);
    return;
  }
  for (const Attribute<Soil>& a : SoilAttributes(like_.bearing.form)) {
    if (a.element != element) continue;
    if (!names.empty() && std::find(names.begin(), names.end(), a.name) == names.end()) continue;
    Set(element, a.name, {"", a.field(like_) / a.to_si, "", 0, kAsOfAnother, like_.name, ""});
  }
  if (names.empty()) SourceOf(element) = AsOfAnother();
}

void SoilFindings::CompanionOfAnother(const std::string& element, const std::string& name,
                                      double value, const char* unit) {
  Report({element + " " + name, value, unit, 0, kAsOfAnother, like_.name, ""});
  SourceOf(element) = AsOfAnother();
}

}  // namespace softsoil
