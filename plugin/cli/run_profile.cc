#include "plugin/cli/run_profile.h"

#include <chrono>

namespace softsoil {
namespace {

double Now() {  // [s]
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

void Profiler::BeginStep() {
  before_ = simulation_.Profile();
  begun_ = Now();
}

void Profiler::EndStep() {
  steps_ += Now() - begun_;
  const softsoilProfile after = simulation_.Profile();
  of_steps_.contact += after.contact - before_.contact;
  of_steps_.flow += after.flow - before_.flow;
  of_steps_.waiting += after.waiting - before_.waiting;
}

RunProfile Profiler::Of(double wall_time) const {
  const softsoilProfile all = simulation_.Profile();
  const double soil = of_steps_.contact + of_steps_.flow + of_steps_.waiting;
  return {{{"mujoco", steps_ - soil},
           {"contact", of_steps_.contact},
           {"flow", of_steps_.flow},
           {"waiting", of_steps_.waiting},
           {"results", wall_time - steps_}},
          {{"stress", all.stress}, {"compaction", all.compaction}}};
}

}  // namespace softsoil
