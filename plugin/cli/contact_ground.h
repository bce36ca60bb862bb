// The ground in the active contact patch of a wheel: that on level undisturbed ground at height 0.
#pragma once

#include <vector>

#include "plugin/cli/simulation.h"

namespace softsoil {

// Volume [m^3] by which the grid nodes in contact have sunk: the sum of sinkage times dx^2, Madsen
// (2014), 6.3.2.1, where it is called total compaction; pushed aside or denser, all of it. Nodes in
// contact are those between the foremost and the rearmost tire node of each grid row along x.
double CompactionVolume(const Simulation& simulation, const std::vector<softsoilContact>& contacts,
                        double grid_spacing);

}  // namespace softsoil
