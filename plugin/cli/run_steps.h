// The time steps of a run, counted from 0 s of simulated time: a run that goes on from a saved
// state counts on, so that it has the same rows at the same times.
#pragma once

#include <string>

namespace softsoil {

class RunSteps {
 public:
  // Those that make up `time` [s] from `start` [s] on. Throws InputError.
  RunSteps(double start, double time, double time_step);

  long first() const { return first_; }
  long last() const { return last_; }                                // at whose start the run ends
  double time_step() const { return time_step_; }                    // [s]
  double start() const { return first_ * time_step_; }               // [s]
  double duration() const { return (last_ - first_) * time_step_; }  // [s]

  // The step that starts nearest to `time` [s]. Throws InputError that begins with `name`, the
  // option, if it is none of this run.
  long Nearest(const std::string& name, double time) const;

  // Whether one of the instants 0, interval, 2 interval, ... [s] is nearest to the start of a step,
  // or of one that was passed over.
  bool Begins(long step, double interval) const;

 private:
  double time_step_;  // [s]
  long first_, last_;
};

}  // namespace softsoil
