// A soil put together from all that is known of it: tests of it, its composition, its density, and
// for the rest another soil.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "terrain/bearing_fit.h"
#include "terrain/shear_fit.h"
#include "terrain/soil_entry.h"
#include "terrain/soil_texture.h"

namespace softsoil {

// What was fitted to a test: its file, and a line about it.
template <class Fit>
struct Tested {
  Fit fit;
  std::string file;
  std::string summary;
};

// Degree of saturation of the pores with water, 0 to 1: actual and of the virgin curve.
struct Saturation {
  double actual, reference;
};

struct SoilEvidence {
  std::optional<Composition> composition;
  const UscsSoil* uscs = nullptr;        // whose composition it is, if a class was named
  std::optional<double> bulk_density;    // [kg/m^3]
  std::optional<Saturation> saturation;  // needs a composition
  std::optional<Tested<BearingFit>> bearing;
  bool is_frictional = false;  // of a test with one plate: take k_c = 0
  std::optional<Tested<ShearFit>> shear;
  std::optional<Soil> like;  // gives every group that nothing else gives
};

// A row of the report. Parameters of the soil are named as in its file: "shear cohesion"; every
// number of the entry has its row.
struct Finding {
  std::string parameter;
  double value;
  std::string unit;
  double confidence;  // half width of the 95 % interval; 0 without one
  std::string how;    // "fit", "printed relation", "fitted relation", "measured", "as of another"
  std::string made_from;
  std::string warning;  // may be empty
};

struct IdentifiedSoil {
  SoilEntry entry;  // complete if nothing is missing
  std::vector<Finding> findings;
  std::string composition;           // in words; empty if it is not known
  std::vector<std::string> missing;  // elements of the entry that nothing gives: "bearing"
  // Parameters that must be > 0 and whose 95 % interval holds zero, so that the entry would say
  // what no test has shown; of k_1 and k_2 one may be zero, not both.
  std::vector<std::string> undetermined;
};

// What was measured counts more than what a relation predicts, and that more than another soil.
// Without a measured density, a soil whose composition is known is taken as never loaded beyond the
// reference stress, and one without composition is as dense as the other soil.
// Throws InputError for a density or saturation that no soil has, a saturation without composition
// or of a coarse soil, and a density alone, which gives no virgin curve.
IdentifiedSoil Identify(const SoilEvidence& evidence);

}  // namespace softsoil
