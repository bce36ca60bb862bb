#include "plugin/soil_binding.h"

#include <Eigen/Geometry>
#include <stdexcept>
#include <utility>

#include "plugin/log.h"
#include "plugin/model_geometry.h"

namespace softsoil {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

// Axes of the tire: y along the spin axis, x and z any two across it.
Matrix3d TireFrame(const Vector3d& axis_b) {
  Matrix3d frame;
  frame.col(1) = axis_b.normalized();
  frame.col(0) = axis_b.unitOrthogonal();
  frame.col(2) = frame.col(0).cross(frame.col(1));
  return frame;
}

Matrix3d Rotation(const mjtNum matrix[9]) {
  return Eigen::Map<const Eigen::Matrix<mjtNum, 3, 3, Eigen::RowMajor>>(matrix);
}

// mjData gives the velocity of a body as that of the point of it that is at the centre of mass of
// its kinematic tree.
TirePose PoseOf(const mjModel* m, const mjData* d, const Wheel& wheel,
                const Matrix3d& tire_frame_b) {
  const int body = wheel.body;
  const Matrix3d body_w = Rotation(d->xmat + 9 * body);
  TirePose pose;
  pose.centre_w = Vector(d->xpos + 3 * body) + body_w * wheel.centre_b;
  pose.frame_w = body_w * tire_frame_b;
  pose.angular_velocity_w = Vector(d->cvel + 6 * body);
  const Vector3d reference_w = Vector(d->subtree_com + 3 * m->body_rootid[body]);
  pose.velocity_w =
      Vector(d->cvel + 6 * body + 3) + pose.angular_velocity_w.cross(pose.centre_w - reference_w);
  return pose;
}

// What results tell before the first evaluation.
TirePose AtRest() {
  return {Vector3d::Zero(), Matrix3d::Identity(), Vector3d::Zero(), Vector3d::Zero()};
}

WrenchRow RowOf(const Wrench& wrench) {
  const Vector3d &f = wrench.force_w, &t = wrench.torque_w;
  return {f.x(), f.y(), f.z(), t.x(), t.y(), t.z()};
}

}  // namespace

SoilBinding::SoilBinding(SoilPlan plan) : plan_(std::move(plan)), shares_(plan_.wheels.size()) {
  for (const Wheel& wheel : plan_.wheels) tire_frame_b_.push_back(TireFrame(wheel.axis_b));
  StartAfresh();
}

void SoilBinding::StartAfresh() {
  soft_wheels_ =
      std::make_unique<SoftWheels>(plan_.soil, plan_.terrain, plan_.ground.height, plan_.tires);
  for (Evaluation* evaluation : {&now_, &pending_}) {
    evaluation->poses.assign(plan_.wheels.size(), AtRest());
    evaluation->forces.assign(plan_.wheels.size(), PatchForces{});
  }
  latest_ = &pending_;
  is_pending_ = false;
  warned_of_depth_ = false;
}

void SoilBinding::OnPassive(const mjModel* m, mjData* d) {
  const StepEvent event = watch_.See(m, d);
  LetHistoryPass(event, d->time);
  try {
    Evaluate(m, d);
  } catch (const std::runtime_error& error) {
    is_pending_ = false;
    latest_ = &pending_;
    RemoveForces(d);
    Say(std::string(error.what()) + "; no soil forces while that lasts");
    return;
  }
  WriteForces(d);
  latest_ = &now_;
  if (event == StepEvent::kTrial) return;
  std::swap(now_, pending_);
  latest_ = &pending_;
  is_pending_ = true;
}

void SoilBinding::LetHistoryPass(StepEvent event, double time) {
  switch (event) {
    case StepEvent::kNextStep:
      if (is_pending_) Commit();
      break;
    case StepEvent::kBack:
      if (time > 0) {
        Say("warning: time ran backwards, but not to 0 s: the ground is undisturbed again");
      }
      StartAfresh();
      break;
    case StepEvent::kJump:
      Say("time leapt ahead by more than a step: the ground stays as it is, slip is forgotten");
      soft_wheels_->ForgetSlip();
      is_pending_ = false;
      break;
    case StepEvent::kFirst:
    case StepEvent::kSameInstant:
    case StepEvent::kTrial: break;
  }
}

void SoilBinding::Commit() {
  soft_wheels_->Commit(pending_.poses, pending_.forces, pending_.h);
  is_pending_ = false;
  if (warned_of_depth_ || !soft_wheels_->ground().LowestVolumeYields()) return;
  Say("warning: the lowest soil volume yields under this load; increase softsoil_volumes (" +
      std::to_string(plan_.terrain.volumes) + ")");
  warned_of_depth_ = true;
}

void SoilBinding::Evaluate(const mjModel* m, const mjData* d) {
  now_.h = m->opt.timestep;
  for (std::size_t i = 0; i < plan_.wheels.size(); ++i) {
    const Wheel& wheel = plan_.wheels[i];
    now_.poses[i] = PoseOf(m, d, wheel, tire_frame_b_[i]);
    try {
      soft_wheels_->Evaluate(static_cast<int>(i), now_.poses[i], now_.h, &now_.forces[i]);
    } catch (const std::runtime_error& error) {
      throw std::runtime_error("wheel \"" + wheel.name + "\": " + error.what());
    }
  }
}

void SoilBinding::WriteForces(mjData* d) {
  for (std::size_t i = 0; i < plan_.wheels.size(); ++i) {
    const int body = plan_.wheels[i].body;
    const Wrench wrench = About(now_.forces[i].wrench, Vector(d->xipos + 3 * body));
    shares_[i].Write(RowOf(wrench), d->xfrc_applied + 6 * body);
  }
}

void SoilBinding::RemoveForces(mjData* d) {
  for (std::size_t i = 0; i < plan_.wheels.size(); ++i) {
    shares_[i].Remove(d->xfrc_applied + 6 * plan_.wheels[i].body);
  }
}

void SoilBinding::Reset(mjData* d) {
  RemoveForces(d);
  watch_ = StepWatch{};
  StartAfresh();
}

bool SoilBinding::RemovesContact(int geom1, int geom2) const {
  if (!plan_.remove_rigid_contact) return false;
  const int ground = plan_.ground.geom;
  return (geom1 == ground && plan_.is_wheels[geom2]) || (geom2 == ground && plan_.is_wheels[geom1]);
}

}  // namespace softsoil
