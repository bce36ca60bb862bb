// Gives every wheel its tire.
#pragma once

#include <mujoco/mujoco.h>

#include <vector>

#include "contact/tire.h"
#include "plugin/settings.h"
#include "plugin/wheel_finder.h"

namespace softsoil {

// Load [N] that a wheel carries if the weight of the vehicle rests on all its wheels alike.
double StaticLoad(const mjModel* m, const std::vector<Wheel>& wheels, const Wheel& wheel);

// A tire of the geom's size, stiff enough to give by 2 % of its radius under `load` [N] on a rigid
// plate: a cylinder, or a torus of the geom's own crown. Its damping is 0.1 of critical.
Tire AutoTire(const Wheel& wheel, double load);

// The tires as named in the settings, from our catalogue and from the files in the settings.
// Warns of a tire whose radius is not the geom's. Throws InputError.
std::vector<Tire> ChooseTires(const mjModel* m, const std::vector<Wheel>& wheels,
                              const Settings& settings);

}  // namespace softsoil
