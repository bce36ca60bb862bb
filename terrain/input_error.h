// The one exception for bad input. Its text says place, name, rule and value, for example
//   models/soils/loam.xml:14: <soil name="loam"> <shear>: cohesion must be >= 0 Pa, got -3000
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace softsoil {

class InputError : public std::runtime_error {
 public:
  explicit InputError(const std::string& message) : std::runtime_error(message) {}
};

// A number as people write it, 0.0005 and not 5e-04: the shortest text that reads back as the same
// double, with an exponent only below 1e-5 and from 1e7.
std::string Shown(double value);

// The same, rounded to so many significant digits.
std::string Rounded(double value, int digits);

// A word of a file that may hold anything: in quotes, what cannot be printed as ?, and cut short.
std::string Quoted(const std::string& word);

// "a, b, c"
std::string Listed(const std::vector<std::string>& words);

// The number that a text is, whatever the locale: decimal, finite, and nothing around it. False if
// the text is none.
bool ParseNumber(const std::string& text, double* value);

// Calls act(); puts the place before the message of an InputError that it throws.
template <class Act>
auto At(const std::string& place, const Act& act) {
  try {
    return act();
  } catch (const InputError& error) {
    throw InputError(place + ": " + error.what());
  }
}

}  // namespace softsoil
