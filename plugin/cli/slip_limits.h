// Slips that a command may ask for.
#pragma once

#include <string>

#include "terrain/input_error.h"
#include "terrain/limits.h"

namespace softsoil {

// [-]  SAE ratio (r w - v)/v; i = 1 - v/(r w) is 0.9 then. Ten per cent given as 10 lies beyond.
constexpr double kMostSlip = 9;

// Throws InputError unless the slip that --slip gives is within its limits.
inline void RequireSlip(Limits limits, double slip) {
  if (Contains(limits, slip)) return;
  throw InputError("--slip must be " + InWords(limits) + ", got " + Shown(slip) +
                   (slip > limits.most ? "; it is a ratio, 0.1 for 10 %" : ""));
}

}  // namespace softsoil
