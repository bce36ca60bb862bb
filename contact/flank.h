// Soil beside the tread that stands in the way of a tire that slides sideways: the ground or the
// berm beyond its edge, which it pushes with its flank. Madsen (2014) section 2.6.1.
#pragma once

#include "contact/wheel_contact.h"

namespace softsoil {

// Adds to `forces` the passive earth pressure, 2.75, on the flank towards which the tread slips:
// on the outermost nodes that touch the ground, across the wheel, over the height by which the soil
// one grid spacing beyond the edge stands above them. It is mobilised as the shear of these nodes
// is (Slip(), terrain/shear.h) and so unloads and reverses with it. A crowned tread that merely
// sinks slides outward on both edges: only what both have in common counts.
void PushFlanks(const TireNodes& nodes, const TirePose& pose, const SoilMap& soils,
                PatchForces* forces);

}  // namespace softsoil
