// The entry of a soil while it is put together: each number that it takes becomes a row of the
// report.
#pragma once

#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "terrain/fitted.h"
#include "terrain/soil_identification.h"

namespace softsoil {

// Whether the 95 % interval of a parameter holds zero.
inline bool HoldsZero(const Fitted& fitted) { return fitted.confidence > std::abs(fitted.value); }

class SoilFindings {
 protected:
  // Starts as the soil `like`, if there is one, but for its layers.
  explicit SoilFindings(const std::optional<Soil>& like);

  Soil& soil() { return result_.entry.soil; }
  std::string& SourceOf(const std::string& element) { return result_.entry.source[element]; }

  void Report(Finding finding) { result_.findings.push_back(std::move(finding)); }

  // Stores a number of the soil, in the unit of the file, and reports it.
  void Set(const std::string& element, const std::string& name, Finding finding);

  // The same for a parameter that a test gives. One that must be > 0 and might be zero is
  // undetermined.
  void SetFitted(const std::string& element, const std::string& name, const Fitted& fitted,
                 const std::string& from, std::string warning = "");

  // The numbers of an element, or some of them, as of the soil `like`; missing without one.
  void OfAnother(const std::string& element, const std::vector<std::string>& names = {});

  // A number beside those of the table, which the entry has of the soil `like`.
  void CompanionOfAnother(const std::string& element, const std::string& name, double value,
                          const char* unit);
  std::string AsOfAnother() const { return "not identified: as of " + like_.name; }

  const bool has_like_;
  Soil like_{};
  IdentifiedSoil result_{};
};

}  // namespace softsoil
