// The bearing sinkage that a wheel leaves in the ground.
#pragma once

#include <optional>
#include <vector>

#include "contact/equilibrium.h"
#include "contact/wheel_contact.h"

namespace softsoil {

// Sinkage at the grid nodes below the wheel where the soil yields: at each, the depth at which
// tire pressure and bearing capacity balance, less what springs back. Fills `sinkage` anew.
//
// It is worked out at the grid nodes, from the tire's surface above each. Scattering the tire's
// nodes onto the grid instead would let the rut creep ahead of the wheel, and the motion
// resistance would disappear.
void PlasticSinkage(const Tire& tire, const TirePose& pose, const SurfacePatch& patch,
                    const SoilMap& soils, std::vector<NodeSinkage>* sinkage);

// Depth [m] that stays of a point in its balance; nothing where the soil does not give way.
std::optional<double> LeftBehind(const PlateCurve& curve, const PressedState& state,
                                 const PressedPoint& point);

}  // namespace softsoil
