// What shear the soil below a tread can bear, at each node and, between lugs, at its sides.
#pragma once

#include "contact/wheel_contact.h"

namespace softsoil {

// Fills in the strength of contacts that are pressed and mobilised.
//
// Rubber on soil, a tread without lugs or the face or the end of a lug: ShearStrength(). Between
// lugs there is no rubber at the surface through their tips. A lug pushes the soil before it and
// the carcass rubs on its top, with what rubber can pass to soil. This block, across the tread,
// fails where that takes less; both can not act at once, for it is the same block.
// - It slides as a whole, soil on soil: along the surface through the tips with c + sigma tan(phi),
//   and along the ground at both edges of the tread with c + sigma_x tan(phi), sigma_x the
//   SideStress() below the mean pressure of the tread. The latter make up the 2 h / b and the 0.64
//   (h / b) arccot(h / b) by which Bekker (1956) increases the cohesive and the frictional thrust
//   of a track with grousers. So it is with close or deep lugs in soft soil.
// - The lug drives a wedge out of it, PassiveForce() on the height of the block, and the carcass
//   slips over the rest. So it is with lugs in firm soil. No surcharge: the carcass is no weight
//   that would ride up with the wedge, and 2.74 is for "little to no surcharge".
void FillStrength(const Tire& tire, const TireNodes& nodes, const SoilMap& soils,
                  std::vector<NodeContact>* contacts);

}  // namespace softsoil
