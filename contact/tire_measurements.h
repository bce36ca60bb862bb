// Load-deflection tests of a tire on a flat plate, as CSV files with units.
#pragma once

#include <string>
#include <vector>

#include "contact/tire_calibration.h"

namespace softsoil {

// One more than the largest form of spring has terms: fewer leave nothing to judge a fit by.
constexpr std::size_t kLeastRowsPerPressure = 4;

struct PressureTest {
  double inflation_pressure;  // [Pa]  0 if the file does not say
  LoadDeflection rows;
};

// The columns deflection and load, and inflation_pressure where the file has several tests, which
// are returned by rising pressure. Throws InputError with file and row: fewer than
// kLeastRowsPerPressure rows of a pressure; deflections that do not rise from row to row of a
// pressure, are negative or not below `radius` [m]; loads that are negative, not 0 at deflection 0
// or, beyond noise, fall as the deflection rises.
std::vector<PressureTest> ReadLoadDeflection(const std::string& file, double radius);

struct ContactWidths {
  std::vector<double> deflection, width;  // [m]  > 0
};
// The columns deflection and contact_width, two rows at least. Throws InputError like the above.
ContactWidths ReadContactWidths(const std::string& file, double radius);

}  // namespace softsoil
