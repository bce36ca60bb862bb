#include "plugin/step_watch.h"

#include <cmath>

namespace softsoil {
namespace {

// Times are sums of many steps, hence the wide bands.
bool IsAbout(double steps, double passed, double h) {
  return passed > (steps - 0.25) * h && passed < (steps + 0.25) * h;
}

}  // namespace

StepEvent StepWatch::See(const mjModel* m, const mjData* d) {
  if (IsStage(m, d->time)) return StepEvent::kTrial;
  start_ = d->time;
  start_h_ = m->opt.timestep;
  middles_ = 0;
  const StepEvent event = UnlessPutBack(EventAt(d->time), m, d);
  if (event == StepEvent::kTrial) return event;
  seen_ = true;
  time_ = d->time;
  h_ = m->opt.timestep;
  CopyMotion(d, m, &pending_);
  trials_ = 0;
  return event;
}

StepEvent StepWatch::EventAt(double time) const {
  if (!seen_) return StepEvent::kFirst;
  const double passed = time - time_;
  if (passed < 0) return StepEvent::kBack;
  if (passed == 0) return StepEvent::kSameInstant;
  if (passed <= 0.75 * h_) return StepEvent::kTrial;
  return IsAbout(1, passed, h_) ? StepEvent::kNextStep : StepEvent::kJump;
}

// A stage of RK4 after the first. The last one comes at the time of the next step, which asks
// again. Steps that differ in a control alone ask for no first stage.
bool StepWatch::IsStage(const mjModel* m, double time) {
  if (!seen_ || m->opt.integrator != mjINT_RK4 || time < start_) return false;
  const double steps_before = std::floor((time - start_) / start_h_);
  if (IsAbout(0.5, time - start_ - steps_before * start_h_, start_h_)) {
    start_ += steps_before * start_h_;
    ++middles_;
    return true;
  }
  if (middles_ != 2 || !IsAbout(1, time - start_, start_h_)) return false;
  middles_ = 0;
  return true;
}

// The event that time alone tells, unless the state tells that the steps since were undone. The
// pending state itself, one step later, is one that the host holds.
StepEvent StepWatch::UnlessPutBack(StepEvent event, const mjModel* m, const mjData* d) {
  if (event != StepEvent::kNextStep && event != StepEvent::kJump) return event;
  const MotionChange change = ChangeOfMotion(pending_, m, d);
  if (change.joints + change.velocities == 0) {
    const bool is_same = event == StepEvent::kJump && IsHeldBack(pending_, d, -1, h_);
    return is_same ? StepEvent::kSameInstant : event;
  }
  if (!IsTrial(change, m, d)) return event;
  ++trials_;
  return StepEvent::kTrial;
}

// Differences begin with velocities, and are no more than two for each velocity and position: a
// host with a habit of its own is to hear of a leap rather than to drive on frozen soil.
bool StepWatch::IsTrial(const MotionChange& change, const mjModel* m, const mjData* d) const {
  if (change.joints + change.velocities > 1) return false;
  if (trials_ > 0) return trials_ < 4 * m->nv;
  return change.velocities == 1 && IsHeldBack(pending_, d, change.dof, h_) && Moves(m, d, h_);
}

void StepWatch::Write(StateWriter& writer) const {
  writer.Put(seen_);
  if (!seen_) return;
  writer.Put(time_);
  writer.Put(h_);
  writer.PutAll(pending_.qpos);
  writer.PutAll(pending_.qvel);
}

void StepWatch::Read(StateReader& reader, int nq, int nv) {
  *this = StepWatch{};
  seen_ = reader.GetFlag();
  if (!seen_) return;
  time_ = reader.GetFinite();
  h_ = reader.GetFinite();
  pending_.qpos = reader.GetAll<double>();
  pending_.qvel = reader.GetAll<double>();
  const auto is_of = [](const std::vector<double>& values, int count) {
    return values.size() == static_cast<std::size_t>(count);
  };
  reader.Require(is_of(pending_.qpos, nq) && is_of(pending_.qvel, nv),
                 "the number of positions and velocities");
}

}  // namespace softsoil
