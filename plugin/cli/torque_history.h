// The rig of the soil bin under a constant torque: it speeds up, and nothing becomes steady.
#pragma once

#include "plugin/cli/drawbar.h"
#include "plugin/cli/drawbar_table.h"

namespace softsoil {

// Drives for options.time after the wheel has settled, writes history.csv, which has the columns of
// wheels.csv, and returns the centre line at each of the contact times.
CentreLines DriveByTorque(const DrawbarOptions& options, Simulation* simulation);

}  // namespace softsoil
