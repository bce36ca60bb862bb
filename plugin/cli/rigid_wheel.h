// The rigid wheel of Wong and Reece beside the tire of softsoil drawbar.
#pragma once

#include "contact/tire.h"
#include "plugin/cli/drawbar.h"
#include "plugin/cli/wong_reece_table.h"
#include "terrain/soil.h"

namespace softsoil {

// A rigid wheel of the tire's unloaded radius and width, driven at those of options.slips that are
// not negative. Throws InputError where the theory has no answer, or the soil does not say where
// it presses most and the options do not either.
WongReeceResults RigidWheelBeside(const Tire& tire, const Soil& soil,
                                  const DrawbarOptions& options);

}  // namespace softsoil
