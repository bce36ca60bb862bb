// Entries of the tire catalogue that softsoil fit-tire writes.
#pragma once

#include <string>
#include <vector>

#include "contact/tire.h"

namespace softsoil {

// Where the groups of numbers of an entry come from.
struct TireSources {
  std::string shape, spring, friction, inflation;
};

// The text of a catalogue file. Numbers have seven digits.
std::string TireFileText(const std::vector<Tire>& tires, const std::vector<TireSources>& sources);

}  // namespace softsoil
