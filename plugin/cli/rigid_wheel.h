// The rigid wheel of Wong and Reece on a soil of the catalogue, alone or beside the tire of
// softsoil drawbar.
#pragma once

#include <optional>

#include "contact/tire.h"
#include "plugin/cli/drawbar.h"
#include "plugin/cli/wong_reece_table.h"
#include "terrain/soil.h"

namespace softsoil {

// What --c1 and --c2 give, if they do. Throws InputError if one is given alone.
std::optional<MaxStress> MaxStressGiven(std::optional<double> c_1, std::optional<double> c_2);

// The soil below a rim of that width [m]. It presses most where `max_stress` says, or else the
// soil. Throws InputError if neither does.
SoilUnderRim UnderRim(const Soil& soil, double width, const std::optional<MaxStress>& max_stress);

// A rigid wheel of the tire's unloaded radius, and of its width if the options give none, driven at
// those of options.slips that are not negative. Throws InputError if there is none, where the
// theory has no answer, and as above.
WongReeceResults RigidWheelBeside(const Tire& tire, const Soil& soil,
                                  const DrawbarOptions& options);

}  // namespace softsoil
