#include "plugin/cli/run_steps.h"

#include <algorithm>
#include <cmath>

#include "terrain/input_error.h"

namespace softsoil {
namespace {

constexpr double kMostSteps = 1e10;

// The step that starts nearest to `start` [s], at which a run begins.
long FirstStep(double start, double time_step) {
  if (start >= 0 && start / time_step <= kMostSteps) return std::lround(start / time_step);
  throw InputError("a run must begin at 0 s to " + Shown(kMostSteps) + " time steps of " +
                   Shown(time_step) + " s, got " + Shown(start) + " s");
}

// Number of steps that make up `time` [s].
long Count(double time, double time_step) {
  if (time >= time_step / 2 && time / time_step <= kMostSteps) {
    return std::max(1L, std::lround(time / time_step));
  }
  throw InputError("--time must be one time step, " + Shown(time_step) + " s, to " +
                   Shown(kMostSteps) + " of them, got " + Shown(time));
}

}  // namespace

RunSteps::RunSteps(double start, double time, double time_step)
    : time_step_(time_step),
      first_(FirstStep(start, time_step)),
      last_(first_ + Count(time, time_step)) {}

long RunSteps::Nearest(const std::string& name, double time) const {
  const double step = std::round(time / time_step_);
  if (step >= first_ && step <= last_) return static_cast<long>(step);
  constexpr int kDigits = 9;
  throw InputError(name + " must be within the run, " + Rounded(start(), kDigits) + " to " +
                   Rounded(last_ * time_step_, kDigits) + " s, got " + Shown(time));
}

bool RunSteps::Begins(long step, double interval) const {
  if (interval <= time_step_) return true;
  const auto begun = [this, interval](long s) {
    return std::ceil((s + 0.5) * time_step_ / interval);
  };
  return begun(step) > begun(step - 1);
}

}  // namespace softsoil
