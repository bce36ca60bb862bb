// Inflation pressure as a setting: entries of one tire at several pressures are a family, and any
// pressure between them is a tire.
#pragma once

#include <string>
#include <vector>

#include "contact/tire.h"

namespace softsoil {

constexpr char kAtPressure = '@';  // 18.4R38@100kPa

// Members of a family that one catalogue holds.
struct TireFamily {
  std::string name;
  double lowest, highest;  // [Pa]  inflation pressures tested
};
std::vector<TireFamily> TireFamilies(const Catalogue<Tire>& catalogue);
// "85 to 125 kPa"
std::string TestedPressures(const TireFamily& family);

// A tire by its name in the catalogue, or FAMILY@PRESSURE such as 18.4R38@100kPa, in Pa, kPa, bar
// or psi. At a tested pressure that is the member; between two it is interpolated linearly:
// spring, damping and crown radius. The gas carries 85 to 90 % of a tire's load (section 4.2) with
// a pressure that is the inflation's, the carcass the rest with one that is not; hence a pressure
// on the ground that is linear in the inflation pressure at a given penetration. Throws InputError
// for an unknown name and outside the tested pressures: nothing is extrapolated.
Tire FindTire(const Catalogue<Tire>& catalogue, const std::string& name);

// Refuses a tire whose name holds an @, and a member of a family that has another shape but for
// the crown radius, another form of spring, another friction, or the pressure of one of the others.
void RequireAgreement(const std::vector<Tire>& others, const Tire& fresh, const XmlEntry& xml);

}  // namespace softsoil
