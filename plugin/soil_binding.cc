#include "plugin/soil_binding.h"

#include <cmath>
#include <stdexcept>
#include <utility>

#include "plugin/log.h"
#include "plugin/model_geometry.h"
#include "plugin/soil_identity.h"
#include "plugin/tire_pose.h"

namespace softsoil {
namespace {

// What results tell before the first evaluation.
TirePose AtRest() {
  const Eigen::Vector3d zero = Eigen::Vector3d::Zero();
  return {zero, Eigen::Matrix3d::Identity(), zero, zero};
}

WrenchRow RowOf(const Wrench& wrench) {
  const Eigen::Vector3d &f = wrench.force_w, &t = wrench.torque_w;
  return {f.x(), f.y(), f.z(), t.x(), t.y(), t.z()};
}

// What makes it impossible to tell what a step is; empty if nothing does.
std::string TimeFault(const mjModel* m, const mjData* d) {
  const double h = m->opt.timestep;
  if (!std::isfinite(d->time)) return "the time is not finite";
  if (h >= 0 && std::isfinite(h)) return "";
  return "<option> timestep: must be >= 0 s, got " + Shown(h);
}

// What a state in the history takes besides what it shares with the one before.
std::size_t OwnBytes(const SoilState& state) {
  std::size_t bytes = sizeof state + state.wheels.ground.OwnBytes();
  for (const SlipMemory& slip : *state.wheels.slip) bytes += slip.size() * sizeof slip.front();
  return bytes + state.pending.poses.size() * sizeof(TirePose) +
         state.shares.size() * sizeof(OwnShare);
}

}  // namespace

SoilBinding::SoilBinding(std::shared_ptr<const SoilPlan> plan)
    : plan_(std::move(plan)),
      soft_wheels_(plan_->soils, plan_->terrain, plan_->ground.height, plan_->tires),
      shares_(plan_->wheels.size()) {
  for (const Wheel& wheel : plan_->wheels) tire_frame_b_.push_back(TireFrame(wheel.axis_b));
  if (HasRoomForMark(plan_->nuserdata) && plan_->history > 0) {
    history_ = std::make_unique<SoilHistory>(plan_->history);
  }
  for (Evaluation* evaluation : {&now_, &pending_}) {
    evaluation->poses.assign(plan_->wheels.size(), AtRest());
    evaluation->forces.assign(plan_->wheels.size(), PatchForces{});
  }
  StartAfresh();
}

void SoilBinding::StartAfresh() {
  SetWheels(soft_wheels_.Undisturbed(), {});
  warned_of_depth_ = false;
}

void SoilBinding::SetWheels(SoftWheelsState wheels, const PendingEvaluation& pending) {
  const bool is_pending = !pending.poses.empty();
  std::vector<TirePose> poses =
      is_pending ? pending.poses : std::vector<TirePose>(shares_.size(), AtRest());
  soft_wheels_.SetState(std::move(wheels));
  bytes_copied_ = soft_wheels_.ground().BytesCopied();  // another ground has counted for itself
  pending_.poses = std::move(poses);
  pending_.h = pending.h;
  for (PatchForces& forces : pending_.forces) forces = PatchForces{};
  is_pending_ = is_pending;
  has_forces_ = !is_pending;
  latest_ = &pending_;
}

void SoilBinding::CompletePending() {
  if (has_forces_) return;
  for (int wheel = 0; wheel < soft_wheels_.size(); ++wheel) {
    soft_wheels_.Evaluate(wheel, pending_.poses[wheel], pending_.h, &pending_.forces[wheel]);
  }
  has_forces_ = true;
}

SoilState SoilBinding::State(const mjData* d) const {
  SoilState state{plan_, soft_wheels_.State(), watch_, {}, shares_, mark_};
  for (std::size_t i = 0; i < shares_.size(); ++i) state.shares[i].Recognise(Row(d, i));
  if (is_pending_) state.pending = {pending_.poses, pending_.h};
  return state;
}

void SoilBinding::SetState(const SoilState& state, mjData* d) {
  // All that may fail comes first.
  RequireSameSoil(state);
  SoilState own = state;
  own.plan = plan_;
  own.shares = shares_;
  for (std::size_t i = 0; i < shares_.size(); ++i) {
    own.shares[i].Expect(state.shares[i]);
    own.shares[i].Recognise(Row(d, i));
  }
  if (history_ != nullptr) history_->Add(&own, OwnBytes(own));
  Restore(state);

  other_mark_ = state.mark;
  if (history_ == nullptr) return;
  mark_ = own.mark;
  PutMark(mark_, plan_->nuserdata, d);
}

void SoilBinding::RequireSameSoil(const SoilState& state) const {
  if (state.plan != plan_) RequireSame(IdentityOf(*state.plan), IdentityOf(*plan_), "the state");
}

void SoilBinding::Restore(const SoilState& state) {
  StepWatch watch = state.watch;
  SetWheels(state.wheels, state.pending);
  watch_ = std::move(watch);
  for (std::size_t i = 0; i < shares_.size(); ++i) shares_[i].Expect(state.shares[i]);
  is_restored_ = true;
}

SoilState SoilBinding::Undisturbed() const {
  SoilState state{plan_, soft_wheels_.Undisturbed(), {}, {}, {}, {}};
  state.shares.resize(shares_.size());
  return state;
}

// The marks of the state of now: the one that we left, and the one that it had where it came from.
void SoilBinding::FollowMark(const mjData* d) {
  const std::lock_guard<std::mutex> lock(following_);
  Follow(d);
}

void SoilBinding::Follow(const mjData* d) {
  if (history_ == nullptr) return;
  const RevisionMark mark = MarkIn(plan_->nuserdata, d);
  if (mark == mark_ || (mark == other_mark_ && !mark.IsUndisturbed())) return;
  if (mark.IsUndisturbed()) {
    StartAfresh();
    watch_ = StepWatch{};
  } else {
    const std::shared_ptr<const SoilState> state = StateMarked(mark);
    RequireSameSoil(*state);
    Restore(*state);
  }
  mark_ = other_mark_ = mark;
}

void SoilBinding::LeaveMark(mjData* d) {
  if (history_ == nullptr) return;
  soft_wheels_.ShareSlip();
  SoilState state = State(d);
  const std::size_t copied = soft_wheels_.ground().BytesCopied();
  history_->Add(&state, copied - std::exchange(bytes_copied_, copied) + OwnBytes(state));
  mark_ = other_mark_ = state.mark;
  PutMark(mark_, plan_->nuserdata, d);
}

void SoilBinding::OnPassive(const mjModel* m, mjData* d) {
  Follow(d);
  const std::string fault = TimeFault(m, d);
  if (!fault.empty()) {
    GoWithout(fault, d);
    return;
  }
  const StepEvent event = watch_.See(m, d);
  LetHistoryPass(event, d->time);
  try {
    Evaluate(m, d);
  } catch (const std::runtime_error& error) {
    if (event != StepEvent::kTrial) is_pending_ = false;
    GoWithout(error.what(), d);
    return;
  }
  WriteForces(d);
  latest_ = &now_;
  if (event != StepEvent::kTrial) {
    std::swap(now_, pending_);
    latest_ = &pending_;
    is_pending_ = has_forces_ = true;
  }
  LeaveMark(d);
}

void SoilBinding::GoWithout(const std::string& fault, mjData* d) {
  latest_ = &pending_;
  RemoveForces(d);
  LeaveMark(d);
  Say(fault + "; no soil forces while that lasts");
}

void SoilBinding::LetHistoryPass(StepEvent event, double time) {
  switch (event) {
    case StepEvent::kNextStep:
      if (std::exchange(is_pending_, false)) Commit();
      break;
    case StepEvent::kBack:
      if (is_restored_) {  // whoever restores a soil wants to keep it
        ForgetSlip();
        break;
      }
      if (time > 0) {
        Say("warning: time ran backwards, but not to 0 s: the ground is undisturbed again");
      }
      StartAfresh();
      break;
    case StepEvent::kJump:
      Say("time leapt ahead by more than a step: the ground stays as it is, slip is forgotten");
      ForgetSlip();
      break;
    case StepEvent::kFirst:
    case StepEvent::kSameInstant:
    case StepEvent::kTrial: break;
  }
  is_restored_ = false;
}

void SoilBinding::ForgetSlip() {
  CompletePending();  // its results still can be asked for
  soft_wheels_.ForgetSlip();
  is_pending_ = false;
}

void SoilBinding::Commit() {
  CompletePending();
  soft_wheels_.Commit(pending_.poses, pending_.forces, pending_.h);
  if (warned_of_depth_ || !soft_wheels_.ground().LowestVolumeYields()) return;
  Say("warning: the lowest soil volume yields under this load; increase softsoil_volumes (" +
      std::to_string(plan_->terrain.volumes) + ")");
  warned_of_depth_ = true;
}

void SoilBinding::Evaluate(const mjModel* m, const mjData* d) {
  now_.h = m->opt.timestep;
  for (std::size_t i = 0; i < plan_->wheels.size(); ++i) {
    const Wheel& wheel = plan_->wheels[i];
    now_.poses[i] = PoseOf(m, d, wheel, tire_frame_b_[i]);
    try {
      soft_wheels_.Evaluate(static_cast<int>(i), now_.poses[i], now_.h, &now_.forces[i]);
    } catch (const std::runtime_error& error) {
      throw std::runtime_error("wheel \"" + wheel.name + "\": " + error.what());
    }
  }
}

void SoilBinding::WriteForces(mjData* d) {
  for (std::size_t i = 0; i < plan_->wheels.size(); ++i) {
    const int body = plan_->wheels[i].body;
    const Wrench wrench = About(now_.forces[i].wrench, Vector(d->xipos + 3 * body));
    shares_[i].Write(RowOf(wrench), Row(d, i));
  }
}

void SoilBinding::RemoveForces(mjData* d) {
  for (std::size_t i = 0; i < shares_.size(); ++i) shares_[i].Remove(Row(d, i));
}

void SoilBinding::Reset(mjData* d) {
  StartAfresh();
  RemoveForces(d);
  watch_ = StepWatch{};
  mark_ = other_mark_ = RevisionMark{};
  if (history_ != nullptr) PutMark(mark_, plan_->nuserdata, d);
}

bool SoilBinding::RemovesContact(int geom1, int geom2) const {
  if (!plan_->remove_rigid_contact) return false;
  const int ground = plan_->ground.geom;
  return (geom1 == ground && plan_->is_wheels[geom2]) ||
         (geom2 == ground && plan_->is_wheels[geom1]);
}

}  // namespace softsoil
