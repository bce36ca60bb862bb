// The rig of the soil bin on its soil: set down, settled, and watched that it does not sink away.
#pragma once

#include <memory>

#include "plugin/cli/simulation.h"
#include "plugin/cli/soil_bin.h"

namespace softsoil {

// The rig at rest; its wheel touches the ground, bumpy or not, from above. `soil_threads` of the
// soil update. Throws InputError. May be called by several threads.
std::unique_ptr<Simulation> MakeRig(const SoilBin& bin, int soil_threads);

// Lets the wheel sink in, without drive, until the ground carries the load [N]. False if it still
// does not after 5 s. Throws as below.
bool Settle(double load, Simulation* rig);

// The same with the brake on: a wheel that is free to roll would roll down a slope.
bool SettleBraked(double load, Simulation* rig);

// One time step. Throws InputError if the wheel sinks to its axle: where that is no longer above
// the undisturbed ground. `load` [N] is for the message.
void StepUnlessSunk(double load, Simulation* rig);

}  // namespace softsoil
