// What softsoil fit-tire says and draws.
#pragma once

#include <string>

#include "plugin/cli/fit_tire.h"

namespace softsoil {

// "85 kPa", or "unknown pressure".
std::string PressureOf(const PressureTest& test);

// Errors and parameters of each form at each pressure, as in Tables 6.1 to 6.3; the best form is
// marked.
void PrintFits(const FittedTire& tire);

// The data and each form's loads as JSON, for the script that draws them.
std::string FitsAsJson(const FittedTire& tire, const std::string& title);

}  // namespace softsoil
