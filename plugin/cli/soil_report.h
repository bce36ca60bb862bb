// What softsoil soil has found out, in words and for the picture.
#pragma once

#include <optional>
#include <string>

#include "terrain/soil_identification.h"

namespace softsoil {

// Readings of the tests, beside the fits that the evidence holds.
struct SoilTests {
  std::optional<PlateSinkage> plate;
  std::optional<ShearTest> shear;
};

// A table of all findings; below it their warnings and a line about each test.
std::string TableOf(const IdentifiedSoil& soil, const SoilEvidence& evidence);

// All findings, readings and fitted values as JSON, SI units: what the picture is drawn from.
std::string JsonOf(const IdentifiedSoil& soil, const SoilEvidence& evidence,
                   const SoilTests& tests);

}  // namespace softsoil
