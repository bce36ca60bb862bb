// The rig of the soil bin under a constant torque: it speeds up, and nothing becomes steady.
#pragma once

#include "contact/tire.h"
#include "plugin/cli/drawbar.h"
#include "plugin/cli/drawbar_table.h"

namespace softsoil {

struct TorqueHistory {
  bool settled;              // before the torque set in
  CentreLines centre_lines;  // at each of the contact times
};

// Drives for options.time after the wheel has settled, and writes history.csv, which has the
// columns of wheels.csv. Throws InputError if the wheel sinks to its axle.
TorqueHistory DriveByTorque(const DrawbarOptions& options, const Tire& tire, Simulation* rig);

}  // namespace softsoil
