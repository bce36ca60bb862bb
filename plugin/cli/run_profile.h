// Where the wall time of a run goes: softsoil run --profile.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "plugin/cli/simulation.h"

namespace softsoil {

// Names, as in summary.json, and wall time [s].
using TimeShares = std::vector<std::pair<std::string, double>>;

struct RunProfile {
  TimeShares run;          // "mujoco", "contact", "flow", "waiting" and "results": their sum
  TimeShares soil_update;  // "stress" and "compaction": in the background, unless with `sync`
};

class Profiler {
 public:
  explicit Profiler(const Simulation& simulation) : simulation_(simulation) {}

  // Around a step of the simulation.
  void BeginStep();
  void EndStep();
  // Of a run that took so long [s].
  RunProfile Of(double wall_time) const;

 private:
  const Simulation& simulation_;
  double begun_ = 0;             // [s]
  softsoilProfile before_ = {};  // the step in hand
  double steps_ = 0;             // [s]
  softsoilProfile of_steps_ = {};
};

}  // namespace softsoil
