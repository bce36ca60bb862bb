// Everything about a simulation on soft soil that follows from the model and its settings.
#pragma once

#include <mujoco/mujoco.h>

#include <vector>

#include "contact/tire.h"
#include "plugin/ground_plane.h"
#include "plugin/settings.h"
#include "plugin/wheel_finder.h"
#include "terrain/soil.h"

namespace softsoil {

struct SoilPlan {
  Soil soil;
  GroundSettings terrain;
  GroundPlane ground;
  std::vector<Wheel> wheels;
  std::vector<Tire> tires;      // by wheel
  std::vector<bool> is_wheels;  // by geom: it turns with a wheel
  bool remove_rigid_contact;
};

// Reads catalogues, finds wheels and ground, and says what was chosen and what looks wrong.
// Throws InputError.
SoilPlan MakePlan(const mjModel* m, const Settings& settings);

}  // namespace softsoil
