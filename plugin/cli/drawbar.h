// softsoil drawbar: a tire on a soil in the soil bin of Madsen (2014), 6.3.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "plugin/cli/soil_bin.h"
#include "plugin/cli/steady_state.h"
#include "terrain/soil.h"

namespace softsoil {

struct DrawbarOptions {
  std::string tire, soil;                           // names in the catalogues
  std::vector<std::string> tire_files, soil_files;  // catalogues besides the shipped ones
  double load = 0;                                  // [N]
  BinMode mode = BinMode::kSlip;
  std::vector<double> slips;  // [-]      (r w - v)/v, in mode slip
  std::vector<double> spins;  // [rad/s]  in mode spin
  double speed = 1;           // [m/s]    in mode slip, and of the freely rolling wheel
  double torque = 0;          // [N m]    in mode torque
  double time = 0;            // [s]      in mode torque, from the instant the torque sets in
  std::vector<double> contact_times;    // [s]  in mode torque
  std::string bumps;                    // of the ground, in mode torque; empty: flat
  bool wong_reece = false;              // also the rigid wheel, in mode slip
  std::optional<double> rigid_width;    // [m]  of the rigid wheel, > 0; none: the tire's
  std::optional<MaxStress> max_stress;  // below the rigid wheel; none: the soil's
  int threads = 1;                      // cases at a time; in mode torque of the soil
  // Settings of softsoil, without the prefix softsoil_.
  std::vector<std::pair<std::string, std::string>> settings;
  std::string folder;
  bool picture = true;
};

// The wheel that is pulled without any torque on it.
struct FreeRolling {
  double slip = 0;                       // [-]  against the unloaded radius
  std::optional<double> rolling_radius;  // [m]  forward speed over spin; none if it hardly turns
  double motion_resistance = 0;          // [N]
  bool steady = false;
  double distance = 0;  // [m]  driven
};

// One row of drawbar.csv.
struct DrawbarCase {
  double asked = 0;  // [-] or [rad/s]  slip or spin
  SteadyState state;
  // [-]  (r_r w - v)/v with the rolling radius r_r; none without it, or on the spot
  std::optional<double> rolling_slip;
};

struct DrawbarResult {
  FreeRolling rolling;
  std::vector<DrawbarCase> cases;  // in the order of the slips or spins
};

// Writes soil_bin.xml, the model that runs, and
//   modes slip and spin  drawbar.csv, centre_line.csv, summary.json; drawbar.png, centre_line.png;
//                        wong_reece.csv, rim_stress.csv, wong_reece.json if asked for
//   mode torque          history.csv, centre_line.csv, summary.json; history.png, centre_line.png
// Refuses bad input with InputError before anything is written, and a load that the soil does not
// carry before any result is; throws std::runtime_error if a case fails.
void Drawbar(const DrawbarOptions& options);

}  // namespace softsoil
