// Drives the rig of the soil bin until nothing changes any more.
//
// The wheel is set down and settles, speeds rise linearly within half a second, and then means over
// windows of time are compared. A window is half a second, in which the sprung mass swings once, or
// the time in which the wheel rolls half its radius, if that is longer. The motion is steady as
// soon as from one window to the next the pull changes by less than 1 % or 0.1 % of the load,
// and the sinkage and the forward speed by less than 1 %. What is reported is the last window.
#pragma once

#include <optional>
#include <vector>

#include "contact/tire.h"
#include "plugin/cli/centre_line.h"
#include "plugin/cli/simulation.h"

namespace softsoil {

// What is prescribed of the rig's motion.
struct BinDrive {
  std::optional<double> speed;  // [m/s]    forward, > 0; none: free
  std::optional<double> spin;   // [rad/s]  >= 0; none: the wheel rolls freely
};

struct SteadyState {
  softsoilWheel wheel = {};      // means; centre, force and torque_at_centre at the end
  double compaction_volume = 0;  // [m^3]  by which the ground in contact has sunk
  // [-]  of the rut that was made meanwhile: soil that became denser, and was not pushed aside
  double densified_share = 0;
  bool steady = false;  // else the wheel did not settle, or the longest distance came first
  double distance = 0;  // [m]    driven
  std::vector<CentreLinePoint> centre_line;
};

// `load` [N] of the wheel; the rig has not been stepped. Throws InputError
// if the wheel sinks to its axle.
SteadyState DriveToSteadyState(const BinDrive& drive, const Tire& tire, double load,
                               Simulation* rig);

}  // namespace softsoil
