// Tells accepted time steps from trial evaluations, from nothing but the times at which MuJoCo
// asks for passive forces.
//
// MuJoCo asks once per step under Euler and implicit, four times under RK4 (t, t + h/2, t + h/2,
// t + h), and whenever the host calls mj_forward. The evaluation at the start of a step is the one
// that counts; it is known to be accepted once the next question comes one time step later.
#pragma once

#include "terrain/state_stream.h"

namespace softsoil {

enum class StepEvent {
  kFirst,        // nothing came before
  kNextStep,     // the pending evaluation is accepted; this one is pending now
  kSameInstant,  // this evaluation replaces the pending one
  kTrial,        // answer it and forget it
  kBack,         // time ran backwards: as when the host has reset the simulation
  kJump,         // time leapt ahead: what lies between is unknown
};

class StepWatch {
 public:
  // MuJoCo evaluates at `time` [s] with the time step h [s].
  StepEvent See(double time, double h) {
    const StepEvent event = EventAt(time);
    if (event == StepEvent::kTrial) return event;
    seen_ = true;
    time_ = time;
    h_ = h;
    return event;
  }

  void Write(StateWriter& writer) const {
    writer.Put(seen_);
    writer.Put(time_);
    writer.Put(h_);
  }
  void Read(StateReader& reader) {  // throws InputError
    seen_ = reader.GetFlag();
    time_ = reader.GetFinite();
    h_ = reader.GetFinite();
  }

  // Whether steps up to `time` [s] went by without a question.
  bool HasMissed(double time) const { return seen_ ? EventAt(time) == StepEvent::kJump : time > 0; }

 private:
  // Times are sums of many steps, hence the wide bands.
  StepEvent EventAt(double time) const {
    if (!seen_) return StepEvent::kFirst;
    const double passed = time - time_;
    if (passed < 0) return StepEvent::kBack;
    if (passed == 0) return StepEvent::kSameInstant;
    if (passed <= 0.75 * h_) return StepEvent::kTrial;
    return passed < 1.25 * h_ ? StepEvent::kNextStep : StepEvent::kJump;
  }

  bool seen_ = false;
  double time_ = 0, h_ = 0;  // [s]  of the pending evaluation
};

}  // namespace softsoil
