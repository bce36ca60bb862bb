// All that the future of the soil of a mjData depends on.
#pragma once

#include <memory>
#include <vector>

#include "contact/soft_wheels.h"
#include "plugin/own_share.h"
#include "plugin/revision_mark.h"
#include "plugin/soil_plan.h"
#include "plugin/step_watch.h"

namespace softsoil {

// The evaluation that becomes history as soon as its time step is known as accepted. Its forces
// follow from it and are not state.
struct PendingEvaluation {
  std::vector<TirePose> poses;  // by wheel; empty if none is pending
  double h = 0;                 // [s]  time step
};

// Copying it is cheap: ground that has not changed since is shared.
struct SoilState {
  std::shared_ptr<const SoilPlan> plan;  // of which soil it is a state
  SoftWheelsState wheels;
  StepWatch watch;
  PendingEvaluation pending;
  std::vector<OwnShare> shares;  // by wheel
  RevisionMark mark;             // by which a mjData names it; none without a history
};

// Writes soil and pending evaluation. Waits for the soil job in flight.
void Write(const SoilState& state, StateWriter& writer);
// What Write() wrote of the same plan; shares and mark as in `undisturbed`. Throws InputError.
SoilState ReadSoilState(StateReader& reader, const SoftWheels& wheels,
                        const SoilState& undisturbed);

}  // namespace softsoil
