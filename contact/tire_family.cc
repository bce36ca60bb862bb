#include "contact/tire_family.h"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "terrain/input_error.h"
#include "terrain/measurements.h"

namespace softsoil {
namespace {

constexpr double kSamePressure = 1e-3;  // relative: 15 psi is 103421.36 Pa, printed 103.4 kPa

std::string InKilopascal(double pressure) { return Shown(std::round(pressure) / 1e3); }

bool IsSamePressure(double a, double b) { return std::abs(a - b) <= kSamePressure * b; }

std::vector<const Tire*> MembersByPressure(const Catalogue<Tire>& catalogue,
                                           const std::string& family) {
  std::vector<const Tire*> members;
  for (const Tire& tire : catalogue.entries()) {
    if (tire.family == family) members.push_back(&tire);
  }
  std::sort(members.begin(), members.end(), [](const Tire* a, const Tire* b) {
    return a->inflation_pressure < b->inflation_pressure;
  });
  return members;
}

[[noreturn]] void RefuseFamily(const Catalogue<Tire>& catalogue, const std::string& name,
                               const std::string& family) {
  std::vector<std::string> known;
  for (const TireFamily& one : TireFamilies(catalogue)) {
    known.push_back(one.name + " (" + TestedPressures(one) + ")");
  }
  throw InputError("unknown tire family \"" + family + "\" in \"" + name +
                   "\"; known families are: " + Listed(known));
}

// Pressure [Pa] of a text such as "100kPa".
double PressureIn(const std::string& name, const std::string& text) {
  std::size_t unit = text.size();
  while (unit > 0 && std::isalpha(static_cast<unsigned char>(text[unit - 1])) != 0) --unit;
  const Unit* const known = FindUnit(Quantity::kPressure, text.substr(unit));
  double value = 0;
  if (known != nullptr && ParseNumber(text.substr(0, unit), &value) && value > 0) {
    return InSi(value, *known);
  }
  throw InputError("tire \"" + name +
                   "\": after @ there must be a pressure > 0 and its unit, one of " +
                   UnitsOf(Quantity::kPressure) + ", got \"" + text + "\"");
}

// The tire at `weight` of the way from a to b.
Tire Between(const Tire& a, const Tire& b, double weight) {
  const auto mix = [weight](double from, double to) { return from + weight * (to - from); };
  Tire tire = a;
  tire.spring.linear = mix(a.spring.linear, b.spring.linear);
  tire.spring.quadratic = mix(a.spring.quadratic, b.spring.quadratic);
  tire.spring.cubic = mix(a.spring.cubic, b.spring.cubic);
  tire.spring.root = mix(a.spring.root, b.spring.root);
  tire.damping = mix(a.damping, b.damping);
  if (std::isfinite(a.shape.crown_radius)) {
    tire.shape.crown_radius = mix(a.shape.crown_radius, b.shape.crown_radius);
  }
  tire.inflation_pressure = mix(a.inflation_pressure, b.inflation_pressure);
  return tire;
}

Tire AtPressure(const std::vector<const Tire*>& members, const std::string& name, double pressure) {
  for (const Tire* member : members) {
    if (IsSamePressure(pressure, member->inflation_pressure)) return *member;
  }
  const TireFamily family{members.front()->family, members.front()->inflation_pressure,
                          members.back()->inflation_pressure};
  if (pressure < family.lowest || pressure > family.highest) {
    throw InputError("tire \"" + name + "\": the inflation pressure must be " +
                     TestedPressures(family) + " as tested, got " + InKilopascal(pressure) +
                     " kPa");
  }
  std::size_t above = 0;
  while (members[above]->inflation_pressure < pressure) ++above;
  const Tire &low = *members[above - 1], &high = *members[above];
  Tire tire = Between(
      low, high,
      (pressure - low.inflation_pressure) / (high.inflation_pressure - low.inflation_pressure));
  tire.description = "between " + low.name + " and " + high.name;
  return tire;
}

// Which terms a spring has.
std::string FormOf(const TireSpring& spring) {
  std::vector<std::string> terms;
  if (spring.linear > 0) terms.emplace_back("linear");
  if (spring.quadratic > 0) terms.emplace_back("quadratic");
  if (spring.cubic > 0) terms.emplace_back("cubic");
  if (spring.root > 0) terms.emplace_back("root");
  return Listed(terms);
}

}  // namespace

std::vector<TireFamily> TireFamilies(const Catalogue<Tire>& catalogue) {
  std::vector<TireFamily> families;
  for (const Tire& tire : catalogue.entries()) {
    if (tire.family.empty()) continue;
    const auto known = std::find_if(families.begin(), families.end(),
                                    [&](const TireFamily& f) { return f.name == tire.family; });
    if (known == families.end()) {
      families.push_back({tire.family, tire.inflation_pressure, tire.inflation_pressure});
    } else {
      known->lowest = std::min(known->lowest, tire.inflation_pressure);
      known->highest = std::max(known->highest, tire.inflation_pressure);
    }
  }
  return families;
}

std::string TestedPressures(const TireFamily& family) {
  const std::string lowest = InKilopascal(family.lowest), highest = InKilopascal(family.highest);
  return (lowest == highest ? lowest : lowest + " to " + highest) + " kPa";
}

Tire FindTire(const Catalogue<Tire>& catalogue, const std::string& name) {
  const std::size_t at = name.rfind(kAtPressure);
  if (at == std::string::npos) return catalogue.Find(name);
  const std::string family = name.substr(0, at);
  const std::vector<const Tire*> members = MembersByPressure(catalogue, family);
  if (family.empty() || members.empty()) RefuseFamily(catalogue, name, family);
  Tire tire = AtPressure(members, name, PressureIn(name, name.substr(at + 1)));
  tire.name = name;
  return tire;
}

void RequireAgreement(const std::vector<Tire>& others, const Tire& fresh, const XmlEntry& xml) {
  if (fresh.name.find(kAtPressure) != std::string::npos) {
    xml.Refuse("the name must not hold an @: after it stands an inflation pressure");
  }
  for (const Tire& other : others) {
    if (fresh.family.empty() || other.family != fresh.family) continue;
    const auto require = [&](bool holds, const std::string& what, const std::string& theirs,
                             const std::string& ours) {
      if (holds) return;
      xml.Refuse("tires of the family \"" + fresh.family + "\" must have the same " + what + ", " +
                 theirs + " in \"" + other.name + "\", got " + ours);
    };
    const auto same = [&](const std::string& what, double theirs, double ours) {
      require(theirs == ours, what, Shown(theirs), Shown(ours));
    };
    const auto type = [](const Tire& t) {
      return std::string(std::isinf(t.shape.crown_radius) ? "cylinder" : "torus");
    };
    require(type(other) == type(fresh), "type of shape", type(other), type(fresh));
    same("radius", other.shape.radius, fresh.shape.radius);
    same("width", other.shape.width, fresh.shape.width);
    require(other.shape.lugs == fresh.shape.lugs, "lugs", "those", "others");
    same("friction", other.soil_friction, fresh.soil_friction);
    const std::string theirs = FormOf(other.spring), ours = FormOf(fresh.spring);
    require(theirs == ours, "terms of the spring", theirs, ours);
    if (IsSamePressure(fresh.inflation_pressure, other.inflation_pressure)) {
      xml.Refuse("\"" + other.name + "\" is the tire of the family \"" + fresh.family + "\" at " +
                 InKilopascal(fresh.inflation_pressure) + " kPa already");
    }
  }
}

}  // namespace softsoil
