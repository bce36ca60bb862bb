// The load-deflection test of a tire on a flat rigid plate. Section 4.2.
#pragma once

#include "contact/tire.h"

namespace softsoil {

// Load [N] that presses the tire the distance z [m] onto the plate, summed over the nodes that
// the contact uses, about `node_spacing` [m] apart.
double FlatPlateLoad(const Tire& tire, double z, double node_spacing);

}  // namespace softsoil
