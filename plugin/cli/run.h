// softsoil run: drives a scene and writes what happened.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "plugin/cli/run_profile.h"
#include "plugin/cli/state_saves.h"
#include "plugin/cli/wheel_columns.h"
#include "plugin/softsoil.h"

namespace softsoil {

struct RunOptions {
  std::string scene;                  // path or name
  double time = 0;                    // [s]  simulated, > 0
  std::string folder;                 // of the results
  std::string controls;               // CSV file, or empty
  double interval = 0.05;             // [s]  simulated time between rows of wheels.csv, > 0
  std::vector<double> contact_times;  // [s]  of contact.csv besides the end
  std::string load_state;             // file from which the run goes on, or empty
  std::vector<StateSave> save_states;
  std::string settings;  // for softsoil_attach()
  bool picture = true;
  bool profile = false;
};

struct WheelResult {
  std::string name;
  WheelMean mean;  // over the last part of the run
};

struct RunResult {
  double start_time = 0;      // [s]
  double simulated_time = 0;  // [s]  from there on
  double wall_time = 0;       // [s]  of the steps
  double averaged_over = 0;   // [s]  last part of the run that WheelResult stands for
  std::vector<WheelResult> wheels;
  softsoilGround ground = {};
  double time_step = 0;          // [s]
  std::uint64_t state_hash = 0;  // at the end
  std::optional<RunProfile> profile;
};

// Writes wheels.csv, contact.csv, terrain.npy, summary.json, terrain.png, contact.png, with a
// profile profile.png, and the states. All times are simulated ones, and a run that goes on from a
// state has the same bits as one that was not interrupted. Refuses bad input with InputError before
// anything is run or written; throws std::runtime_error if the run fails.
void Run(const RunOptions& options);

}  // namespace softsoil
