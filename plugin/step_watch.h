// Tells accepted time steps from trial evaluations, from nothing but the times and states at which
// MuJoCo asks for passive forces.
//
// MuJoCo asks once per step under Euler and implicit, four times under RK4 (t, t + h/2, t + h/2,
// t + h), and whenever the host calls mj_forward or mj_inverse. The evaluation at the start of a
// step is the one that counts; it is known to be accepted once the next question comes one time
// step later.
//
// mjd_transitionFD of MuJoCo 2.2.2 takes many steps from one state and puts back all but time,
// which so runs on. Its questions differ from the pending one in one velocity, then in the
// position of one joint, while others that are accelerated stay as they were. No free motion does
// that. A host that holds a model in place does nearly that; hence a trial needs such signs and
// wherever they are in doubt the step is accepted.
#pragma once

#include <mujoco/mujoco.h>

#include "plugin/motion_state.h"
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
  // MuJoCo evaluates the state of d.
  StepEvent See(const mjModel* m, const mjData* d);

  // The pending evaluation; what a host tries between two steps is no state.
  void Write(StateWriter& writer) const;
  // Of a model with so many positions and velocities. Throws InputError.
  void Read(StateReader& reader, int nq, int nv);

  // Whether steps up to `time` [s] went by without a question.
  bool HasMissed(double time) const { return seen_ ? EventAt(time) == StepEvent::kJump : time > 0; }

 private:
  StepEvent EventAt(double time) const;
  bool IsStage(const mjModel* m, double time);
  StepEvent UnlessPutBack(StepEvent event, const mjModel* m, const mjData* d);
  bool IsTrial(const MotionChange& change, const mjModel* m, const mjData* d) const;

  bool seen_ = false;
  double time_ = 0, h_ = 0;  // [s]  of the pending evaluation
  MotionState pending_;
  int trials_ = 0;  // steps tried from the pending state and put back

  double start_ = 0, start_h_ = 0;  // [s]  of the step whose stages may follow, trials included
  int middles_ = 0;                 // stages in the middle of it that were asked for
};

}  // namespace softsoil
