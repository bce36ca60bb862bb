// The soil of one mjData: what happens at each call of MuJoCo's passive callback.
#pragma once

#include <mujoco/mujoco.h>

#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "contact/soft_wheels.h"
#include "plugin/soil_history.h"
#include "plugin/soil_plan.h"
#include "plugin/soil_state.h"

namespace softsoil {

class SoilBinding {
 public:
  // Soil for a mjData of the model of the plan; undisturbed.
  explicit SoilBinding(std::shared_ptr<const SoilPlan> plan);
  SoilBinding(const SoilBinding&) = delete;  // latest_ points into the object
  SoilBinding& operator=(const SoilBinding&) = delete;

  // Adds the forces of the soil on the wheels to xfrc_applied, and lets history pass if a time
  // step was accepted since the last call. If a pose or the time is not finite, as in a simulation
  // that diverges, it says so and leaves the wheels without soil until they are finite again.
  //
  // Follows the mark first; throws what that throws.
  void OnPassive(const mjModel* m, mjData* d);

  // Takes the soil's share out of xfrc_applied.
  void RemoveForces(mjData* d);

  // As just made: undisturbed ground, wheels at rest, no forces in xfrc_applied.
  void Reset(mjData* d);

  // If userdata has the mark of another state of the soil, that state is the one of now. Throws
  // InputError if it is no longer held. From any number of threads, but for the one that steps.
  void FollowMark(const mjData* d);

  // The state of now, from any number of threads at a time, and one as it was, of the same plan or
  // one that gives the same soil. The rows of xfrc_applied and the mark in userdata belong to it.
  SoilState State(const mjData* d) const;
  // If SetState() throws, InputError for one, nothing has changed.
  void SetState(const SoilState& state, mjData* d);
  SoilState Undisturbed() const;

  // Whether steps went by, until `time` [s], at which MuJoCo did not ask for forces.
  bool WasPassedOver(double time) const { return watch_.HasMissed(time); }

  // Whether the contact of two geoms is to be discarded.
  bool RemovesContact(int geom1, int geom2) const;

  const SoilPlan& plan() const { return *plan_; }
  SoftWheels& soft_wheels() { return soft_wheels_; }
  const SoftWheels& soft_wheels() const { return soft_wheels_; }

  // Of the last evaluation, trials included.
  const TirePose& pose(int wheel) const { return latest_->poses[wheel]; }
  const PatchForces& forces(int wheel) {
    if (latest_ == &pending_) CompletePending();
    return latest_->forces[wheel];
  }

 private:
  struct Evaluation {
    std::vector<TirePose> poses;
    std::vector<PatchForces> forces;
    double h = 0;  // [s]
  };

  void Follow(const mjData* d);
  void StartAfresh();
  // If it throws nothing has changed.
  void SetWheels(SoftWheelsState wheels, const PendingEvaluation& pending);
  void CompletePending();
  void ForgetSlip();
  double* Row(mjData* d, std::size_t wheel) const {
    return d->xfrc_applied + 6 * plan_->wheels[wheel].body;
  }
  const double* Row(const mjData* d, std::size_t wheel) const {
    return Row(const_cast<mjData*>(d), wheel);
  }
  void RequireSameSoil(const SoilState& state) const;  // throws InputError
  void Restore(const SoilState& state);                // of the same soil
  void LeaveMark(mjData* d);
  // Takes the forces away and says why.
  void GoWithout(const std::string& fault, mjData* d);
  void LetHistoryPass(StepEvent event, double time);
  void Commit();
  void Evaluate(const mjModel* m, const mjData* d);
  void WriteForces(mjData* d);

  std::shared_ptr<const SoilPlan> plan_;
  std::vector<Eigen::Matrix3d> tire_frame_b_;  // by wheel: axes of the tire in the body's frame
  SoftWheels soft_wheels_;
  std::vector<OwnShare> shares_;  // by wheel
  StepWatch watch_;

  // Two evaluations that change places, so that a step allocates nothing: the one that is asked
  // for now, and the pending one, which is history as soon as its time step is known as accepted.
  Evaluation now_, pending_;
  bool is_pending_ = false;
  bool has_forces_ = true;    // the pending one; if restored, only once they are asked for
  bool is_restored_ = false;  // no question since
  bool warned_of_depth_ = false;
  const Evaluation* latest_ = &pending_;

  std::unique_ptr<SoilHistory> history_;  // null: no marks
  RevisionMark mark_;                     // of the state of now, as in userdata
  RevisionMark other_mark_;               // the one it had where it came from
  std::mutex following_;                  // of threads that copy from one mjData
  std::size_t bytes_copied_ = 0;          // until the last revision
};

}  // namespace softsoil
