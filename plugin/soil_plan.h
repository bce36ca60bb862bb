// Everything about a simulation on soft soil that follows from the model and its settings.
#pragma once

#include <mujoco/mujoco.h>

#include <vector>

#include "contact/tire.h"
#include "plugin/ground_plane.h"
#include "plugin/settings.h"
#include "plugin/wheel_finder.h"
#include "terrain/soil_map.h"

namespace softsoil {

struct SoilPlan {
  SoilMap soils;
  GroundSettings terrain;
  GroundPlane ground;  // with the bumps
  NurbsBumps bumps;
  std::vector<Wheel> wheels;
  std::vector<Tire> tires;      // by wheel
  std::vector<bool> is_wheels;  // by geom: it turns with a wheel
  bool remove_rigid_contact;
  std::size_t history;        // [bytes]  for past states
  std::size_t model_content;  // ContentOf() the model
  int nq, nv, nuserdata;      // of the model
};

// Hash of the names, the sizes and the <custom> elements of a model.
std::size_t ContentOf(const mjModel* m);

// Reads catalogues, finds wheels and ground, and says what was chosen and what looks wrong.
// Throws InputError.
SoilPlan MakePlan(const mjModel* m, const Settings& settings);

}  // namespace softsoil
