// Geoms that meet the soil with their own surface: treads with lugs, rigid wheels with grousers,
// track shoes, plates, blades, the belly of a vehicle.
#pragma once

#include <mujoco/mujoco.h>

#include <string>
#include <vector>

#include "contact/tire.h"
#include "plugin/wheel_finder.h"

namespace softsoil {

constexpr char kRigidTire[] = "rigid";

// Gives wheels the surface of those of their geoms that are named, meshes or boxes. A geom of a
// body that is none of the wheels adds one: it turns about the body's hinge if that may be a spin
// axis, else it does not turn. Throws InputError.
void AddShapes(const mjModel* m, const std::vector<std::string>& geoms, std::vector<Wheel>* wheels);

// The tire of a wheel with a shape if none is named: rigid. It is as stiff as the time step allows,
// m / (4 h^2) where all of its largest side touches, m from the body's inverse mass, which is a
// mean over the axes: between a sixteenth and a fifth of where the time stepping becomes unstable.
// It is damped by 0.1 of critical.
Tire RigidTire(const mjModel* m, const Wheel& wheel);

// The tire with the surface of the wheel, which bounds the shape of the tire.
Tire WithShape(Tire tire, const Wheel& wheel);

}  // namespace softsoil
