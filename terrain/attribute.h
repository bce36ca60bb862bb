// One table of attributes says what a catalogue entry holds. Reading, listing and the tests that
// the documentation agrees all use the same table.
#pragma once

#include <string>
#include <vector>

namespace softsoil {

enum class Range {
  kAny,
  kNotNegative,
  kPositive,
  kUpToOne,
  kUpTo90Degrees,
  kConcentration,
  kTireSize
};

// Whether a value lies in a range, and the range in words: "> 0".
bool Contains(Range range, double value);
std::string InWords(Range range);

// A number in an XML element below the entry. `Entry` is the struct that is filled.
template <class Entry>
struct Attribute {
  const char* element;  // <bearing>
  const char* name;     // k_phi
  const char* unit;     // unit in the file
  double to_si;         // factor from that unit to the one used inside
  Range range;
  const char* meaning;
  double& (*field)(Entry&);
  bool optional = false;  // zero where it is left out
};

}  // namespace softsoil
