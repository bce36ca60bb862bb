// The one exception for bad input. Its text says place, name, rule and value, for example
//   models/soils/loam.xml:14: <soil name="loam"> <shear>: cohesion must be >= 0 Pa, got -3000
#pragma once

#include <stdexcept>
#include <string>

namespace softsoil {

class InputError : public std::runtime_error {
 public:
  explicit InputError(const std::string& message) : std::runtime_error(message) {}
};

// A number as people write it: the shortest text that reads back as the same double.
std::string Shown(double value);

}  // namespace softsoil
