// Which soil lies where on the ground of a model.
#pragma once

#include <mujoco/mujoco.h>

#include "plugin/ground_plane.h"
#include "plugin/settings.h"
#include "terrain/soil_map.h"

namespace softsoil {

// The soil of the settings, and on it those of softsoil_regions: a region is what the box of a site
// cuts out of the ground plane. The site must belong to the world body; its z axis must stand
// upright on the plane. Throws InputError.
SoilMap ChooseSoils(const mjModel* m, const GroundPlane& ground, const Settings& settings);

}  // namespace softsoil
