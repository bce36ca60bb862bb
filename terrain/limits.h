// What a number may be, both ends included.
#pragma once

#include <string>

#include "terrain/input_error.h"

namespace softsoil {

struct Limits {
  double least, most;
};

inline bool Contains(Limits limits, double value) {
  return value >= limits.least && value <= limits.most;
}

// "0.001 to 10"
inline std::string InWords(Limits limits) {
  return Shown(limits.least) + " to " + Shown(limits.most);
}

}  // namespace softsoil
