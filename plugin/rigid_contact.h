// MuJoCo's own contact between wheels and the rigid plane that soft soil replaces.
#pragma once

#include <mujoco/mujoco.h>

#include <string>
#include <vector>

#include "plugin/wheel_finder.h"

namespace softsoil {

// Whether MuJoCo lets two geoms collide by their bodies, contype and conaffinity, as its built-in
// filter does. A callback replaces all of that filter; only <exclude> acts before it.
bool MayCollide(const mjModel* m, int geom1, int geom2);

// By geom: whether it turns with a wheel.
std::vector<bool> GeomsOfWheels(const mjModel* m, const std::vector<Wheel>& wheels);

// What to write into the model such that wheels no longer touch the ground geom, with the names
// and bits of this model; empty if they do not touch it. `filtered`: a contact filter takes out
// what it can, which is all but <pair>.
std::string RigidContactWarning(const mjModel* m, int ground, const std::vector<Wheel>& wheels,
                                bool filtered);

}  // namespace softsoil
