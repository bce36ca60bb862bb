#include "contact/mesh_contact.h"

#include <algorithm>
#include <cmath>

#include "contact/equilibrium.h"
#include "contact/mesh_nodes.h"
#include "contact/mesh_sinkage.h"
#include "contact/node_laws.h"
#include "terrain/constants.h"

namespace softsoil {
namespace {

using Eigen::Vector3d;

constexpr double kLeastSideways = 1e-6;  // [-]  1 - n_z^2 below it is rounding
constexpr double kLeastDown = 1e-6;      // [-]  -n_z below it too

// The curve of which a face that looks down at an angle gets the share n_z^2.
PlateCurve Scaled(PlateCurve curve, double share) {
  curve.k_e *= share;
  curve.unloading.k_0 *= share;
  curve.unloading.A_u *= share;
  return curve;
}

// Share of the passive pressure that is mobilised after moving into the soil at v [m/s] for h [s].
double Push(double share, double v, double h, double K) {
  return std::max(0.0, Slip(Mobilisation{share, 0}, v, 0, h, K).t);
}

// Height [m] of the soil that stands before a face: one grid spacing away from it.
double HeightBefore(const Vector3d& node_w, const Vector3d& normal_w, const SurfacePatch& patch) {
  const Vector3d away = Vector3d(normal_w.x(), normal_w.y(), 0).normalized() * patch.spacing();
  return patch.HeightAt(node_w.x() + away.x(), node_w.y() + away.y());
}

}  // namespace

// What is the same for all nodes.
struct MeshContact::Question {
  const TirePose& pose;
  const SurfacePatch& patch;
  const double h;  // [s]
  TreadCurves curves;
  SoilStrengths strengths;
  // Of the node in question.
  const Soil* soil = nullptr;
  const SoilStrengths::OfSoil* strength = nullptr;
  PlateCurve curve = {};

  void SetPlace(const Vector3d& node_w, NodeContact* contact) {
    contact->soil = curves.soils().NumberAt(node_w.x(), node_w.y());
    soil = &curves.soils()[contact->soil];
    strength = &strengths.In(contact->soil);
    curve = curves.In(contact->soil).below_lugs;
  }
};

MeshContact::MeshContact(const Tire& tire, double node_spacing)
    : tire_(tire), nodes_(MakeMeshNodes(*tire.mesh, node_spacing)) {
  for (std::size_t i = 0; i < nodes_.size(); ++i) memory_.push_back({static_cast<int>(i), {0, 0}});
}

void MeshContact::Reset() {
  for (NodeSlip& s : memory_) s = {s.node, {0, 0}};
}

void MeshContact::Evaluate(const TirePose& pose, const Surface& surface, const SoilMap& soils,
                           double h, PatchForces* forces) const {
  RequireUsable(pose);
  const Shadow shadow = ShadowOf(*tire_.mesh, {pose.centre_w, pose.frame_w});
  const double margin = surface.spacing();
  surface.CopyPatch(shadow.x_min - margin, shadow.x_max + margin, shadow.y_min - margin,
                    shadow.y_max + margin, &forces->patch);
  forces->wrench = Wrench{};
  forces->wrench.at_w = pose.centre_w;
  forces->contacts.clear();
  forces->surface.clear();
  Question question = {pose, forces->patch, h, TreadCurves(soils, tire_.shape),
                       SoilStrengths(soils)};
  const Vector3d up_t = pose.frame_w.row(2);
  const double highest = forces->patch.highest() - pose.centre_w.z();
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    if (nodes_.position_t[i].dot(up_t) >= highest) continue;
    NodeContact contact{};
    if (!Press(static_cast<int>(i), &question, &contact)) continue;
    Rub(question, &contact);
    const Vector3d force_w = contact.normal_force_w + contact.shear_force_w;
    forces->wrench.force_w += force_w;
    forces->wrench.torque_w += (contact.point_w - pose.centre_w).cross(force_w);
    forces->contacts.push_back(contact);
    forces->surface.push_back({contact.point_w, -force_w, contact.slip_sinkage * contact.area});
  }
}

bool MeshContact::Press(int i, Question* asked, NodeContact* contact) const {
  const Question& question = *asked;
  const TirePose& pose = question.pose;
  const Vector3d arm_w = pose.frame_w * nodes_.position_t[i];
  const Vector3d node_w = pose.centre_w + arm_w, normal_w = pose.frame_w * nodes_.normal_t[i];
  const double height = question.patch.HeightAt(node_w.x(), node_w.y());
  const double sideways = 1 - normal_w.z() * normal_w.z();
  const double before =
      sideways > kLeastSideways ? HeightBefore(node_w, normal_w, question.patch) - node_w.z() : 0;
  const bool bears = normal_w.z() < -kLeastDown && height > node_w.z();
  if (!bears && before <= 0) return false;

  const SurfacePoint ground = question.patch.At(node_w.x(), node_w.y());
  asked->SetPlace(node_w, contact);
  contact->node = i;
  contact->point_w = node_w;
  contact->area = nodes_.area[i];
  contact->depth = ground.sinkage + ground.height - node_w.z();
  if (bears) contact->pressure = BearingShare(i, question, ground, contact);
  if (before > 0) {
    const double v = (pose.velocity_w + pose.angular_velocity_w.cross(arm_w)).dot(normal_w);
    const double K = question.soil->shear.modulus;
    contact->pushed = Push(memory_[i].pushed, v, question.h, K);
    const double damped = Push(contact->pushed, v, ShearLead(std::abs(v), K), K);
    contact->pressure +=
        sideways * damped *
        PassivePressure(question.strength->passive, question.strength->unit_weight, before);
  }
  if (!bears && contact->pushed == 0) return false;
  contact->normal_force_w = -contact->pressure * contact->area * normal_w;
  return true;
}

double MeshContact::BearingShare(int i, const Question& question, const SurfacePoint& ground,
                                 NodeContact* contact) const {
  const Vector3d normal_w = question.pose.frame_w * nodes_.normal_t[i];
  const double share = normal_w.z() * normal_w.z();
  const PlateCurve curve = Scaled(question.curve, share);
  PressedPoint point;
  // However the surface lies, once the soil has given all the way its depth is that of the node.
  const double descent = std::max(Descent(normal_w, ground.slope_x, ground.slope_y), kLeastDescent);
  point.penetration = (ground.height - contact->point_w.z()) / descent;
  point.depth = ground.sinkage - ground.slip_sinkage;
  point.loose = ground.loose;
  point.release = 1;
  point.deepening = descent;
  const PressedState state = Equilibrium(tire_.spring, curve, point);
  contact->depth = state.depth + ground.slip_sinkage;
  contact->point_w -= state.penetration * normal_w;
  const double most =
      state.yields ? state.pressure : BearingPressure(curve.k_e, curve.n, state.depth);
  return std::clamp(state.pressure + tire_.damping * ClosingSpeed(question.pose, ground), 0.0,
                    most);
}

void MeshContact::Rub(const Question& question, NodeContact* contact) const {
  const int i = contact->node;
  const TirePose& pose = question.pose;
  const Shear& shear = question.soil->shear;
  const Vector3d tangent_w = pose.frame_w * nodes_.tangent_t[i];
  const Vector3d binormal_w = pose.frame_w * nodes_.binormal_t[i];
  const Vector3d slip_w =
      pose.velocity_w + pose.angular_velocity_w.cross(contact->point_w - pose.centre_w);
  const double v_t = slip_w.dot(tangent_w), v_b = slip_w.dot(binormal_w), K = shear.modulus;
  contact->mobilisation = softsoil::Slip(memory_[i].mobilisation, v_t, v_b, question.h, K);
  const double lead = ShearLead(std::sqrt(v_t * v_t + v_b * v_b), K);
  const Mobilisation damped = softsoil::Slip(contact->mobilisation, v_t, v_b, lead, K);
  const double strength =
      ShearStrength(question.strength->shear, tire_.soil_friction, contact->pressure) *
      HumpFactor(shear, damped.slip);
  contact->slip_sinkage = SlipSinkageOf(question, *contact);
  contact->shear_force_w =
      -strength * contact->area * (damped.t * tangent_w + damped.b * binormal_w);
}

// Of the area as seen from above; side faces do not press the soil down.
double MeshContact::SlipSinkageOf(const Question& question, const NodeContact& c) const {
  const Soil& soil = *question.soil;
  const double down = -(question.pose.frame_w * nodes_.normal_t[c.node]).z();
  if (soil.slip_sinkage == 0 || down <= 0) return 0;
  const double capacity = BearingPressure(question.curve.k_e, question.curve.n, c.depth);
  if (capacity <= 0) return 0;
  const double pressure = std::min(c.pressure, capacity);
  const double strength = ShearStrength(question.strength->shear, tire_.soil_friction, pressure);
  const double way = c.mobilisation.slip - memory_[c.node].mobilisation.slip;
  return down * SlipSinkage(soil.slip_sinkage, strength / capacity, c.mobilisation, way);
}

void MeshContact::Commit(const PatchForces& forces) {
  Reset();
  for (const NodeContact& c : forces.contacts) {
    memory_[c.node].mobilisation = c.mobilisation;
    memory_[c.node].pushed = c.pushed;
  }
}

SlipMemory MeshContact::Slip() const {
  const auto is_empty = [](const NodeSlip& s) {
    return s.mobilisation.t == 0 && s.mobilisation.b == 0 && s.mobilisation.slip == 0 &&
           s.pushed == 0;
  };
  SlipMemory slip;
  std::remove_copy_if(memory_.begin(), memory_.end(), std::back_inserter(slip), is_empty);
  return slip;
}

void MeshContact::SetSlip(const SlipMemory& slip) {
  Reset();
  for (const NodeSlip& s : slip) memory_[s.node] = s;
}

}  // namespace softsoil
