// Pedotransfer relations: what a soil does, estimated from what it is made of.
//
// Madsen (2014), section 3.3 takes them from Ayers and Bozdech but prints the coefficients of the
// rebound index alone (equation 3.9). The others have the forms that the section describes, with
// coefficients fitted to the five soils printed there and in 3.4 and 6.1. Each relation carries
// the soils it was made from; outside their range it extrapolates and says so.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "terrain/constants.h"
#include "terrain/limits.h"
#include "terrain/soil_texture.h"

namespace softsoil {

// [-]  Fitted: all five soils within the rounding of the print, which leaves 14.650 to 14.653.
inline double ClayIndex(const Texture& soil) { return soil.clay / 14.652; }

// [m]  Fitted: five soils, three numbers, within 0.0025 mm of what is printed or follows from the
// grain size index. The coefficients are middles of the sand, silt and clay classes.
inline double MeanGrainSize(const Texture& soil) {
  return (2.585 * soil.sand + 0.041 * soil.silt + 0.0016 * soil.clay) * 1e-5;
}

// [-]  1.76 mm / d, fitted: the three soils of which both are printed, exact. d in [m].
inline double GrainSizeIndex(double mean_grain_size) { return 1.76e-3 / mean_grain_size; }

// [kg/m^3]  R = 11 + 4 GSI. Equation 3.9, printed there as a time constant; the values printed for
// CH, ML, CL and MH are this rebound index.
inline double ReboundIndex(double grain_size_index) { return 11 + 4 * grain_size_index; }

// [kg/m^3]  C, a second-order polynomial of the clay share [%], as 3.3 says after Larson (1980);
// fitted: four soils, three numbers.
inline double CompressionIndex(double clay) {
  return 219.4 + 12.351 * clay - 0.129745 * clay * clay;
}

// [kg/m^3]  Density at 98 kPa on the virgin curve, again of second order in the clay share [%];
// fitted through CH, ML and CL: no check. MH is printed off it, 1200 instead of 1289.
inline double DensityAt98kPa(double clay) {
  return 1295.62 + 4.7551 * clay - 0.141845 * clay * clay;
}
constexpr double kReferenceStress = 98e3;  // [Pa]

// [m]  K, linear in both indices, as 3.3 says; fitted: four soils, three numbers, within 0.001 mm.
// Table 3.1 prints cm; 6.1 shows that it is mm.
inline double ShearModulus(double clay_index, double grain_size_index) {
  return (21.751 - 3.2244 * clay_index + 0.4740 * grain_size_index) * 1e-3;
}

// [rad]  Linear in both indices and the rating cone index, as 3.3 says; fitted: four numbers from
// four soils, no check. The cone index enters as a constant, as only one value of it is printed.
inline double FrictionAngle(double clay_index, double grain_size_index, RatingConeIndex rating) {
  const double constant = rating == RatingConeIndex::k80 ? 24.44 : 24.02;
  return (constant - 3.056 * clay_index + 1.028 * grain_size_index) * kPi / 180;
}

// [Pa]  Linear in both indices, zero where that is negative; fitted and underdetermined: only CH
// and CL are printed above zero, and 12.07 is the least that leaves none for MH.
inline double Cohesion(double clay_index, double grain_size_index) {
  return std::max(0.0, 8262 + 12070 * clay_index - 8662.5 * grain_size_index);
}

// [kg/m^3 per unit of saturation]  S_T of fine soils, a straight line in the silt share [%] through
// the two that are printed, CH and ML. Printed in g/cm^3 without saying per what: per percent, for
// otherwise soaking a dry soil would change its density by 0.5 % at most.
inline double MoistureSlope(double silt) { return (5.962 - 0.04979 * silt) * 100; }

// What a relation asks about a soil and the range of the soils it was made from.
struct RelationInput {
  const char* name;
  const char* unit;
  double (*of)(const Composition&);
  Limits made_from;
};

// One relation; the same table serves the table of results, the documentation and the tests.
struct Relation {
  const char* result;  // "compression index"
  const char* unit;    // of the result, the same as in a soil file
  bool coefficients_are_printed;
  const char* made_from;  // the soils
  std::vector<RelationInput> inputs;
  double (*law)(const Composition&);  // in `unit`
  const char* caution;                // always to be said; may be empty
};
const std::vector<Relation>& Relations();

// A result with everything needed to judge it.
struct Estimate {
  double value;           // in the unit of the relation
  std::string how;        // "printed relation", "fitted relation"
  std::string made_from;  // "CH, ML, CL, MH; clay 13.6 to 73.3 %"
  std::string warning;    // the caution, and every input outside that range; may be empty
};

// Applies the relation with this result. Throws InputError if there are no data for such a soil:
// the moisture slope of a coarse one.
Estimate Apply(const std::string& result, const Composition& soil);

}  // namespace softsoil
