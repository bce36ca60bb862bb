#include "contact/wheel_contact.h"

#include <algorithm>
#include <cmath>

#include "contact/equilibrium.h"
#include "contact/node_laws.h"

namespace softsoil {
namespace {

using Eigen::Vector3d;

// The part of the surface that a wheel can reach: its bounding box.
void CopyFootprint(const TireShape& shape, const TirePose& pose, const Surface& surface,
                   SurfacePatch* patch) {
  const Vector3d axis = pose.frame_w.col(1);
  const auto half_extent = [&](int k) {
    return shape.radius * std::sqrt(std::max(0.0, 1 - axis[k] * axis[k])) +
           shape.width / 2 * std::abs(axis[k]);
  };
  const Vector3d& c = pose.centre_w;
  surface.CopyPatch(c.x() - half_extent(0), c.x() + half_extent(0), c.y() - half_extent(1),
                    c.y() + half_extent(1), patch);
}

}  // namespace

Wrench About(const Wrench& wrench, const Vector3d& at_w) {
  return {wrench.force_w, wrench.torque_w + (wrench.at_w - at_w).cross(wrench.force_w), at_w};
}

WheelContact::WheelContact(const Tire& tire, double node_spacing)
    : tire_(tire), nodes_(MakeTireNodes(tire.shape, node_spacing)) {
  Reset();
}

void WheelContact::Reset() { mobilisation_.assign(nodes_.size(), {0, 0}); }

void WheelContact::Evaluate(const TirePose& pose, const Surface& surface, const Soil& soil,
                            double h, PatchForces* forces) const {
  RequireUsable(pose);
  CopyFootprint(tire_.shape, pose, surface, &forces->patch);
  forces->wrench = Wrench{};
  forces->wrench.at_w = pose.centre_w;
  forces->contacts.clear();
  forces->surface.clear();
  const Vector3d up_t = pose.frame_w.row(2);
  const PlateCurve curve = CurveUnder(soil.bearing, soil.unloading, tire_.shape.width);
  const double highest = forces->patch.highest() - pose.centre_w.z();
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    if (nodes_.position_t[i].dot(up_t) >= highest) continue;
    NodeContact contact{};
    if (!Press(static_cast<int>(i), pose, forces->patch, curve, &contact)) continue;
    Rub(pose, soil, h, &contact);
    const Vector3d force_w = contact.normal_force_w + contact.shear_force_w;
    forces->wrench.force_w += force_w;
    forces->wrench.torque_w += (contact.point_w - pose.centre_w).cross(force_w);
    forces->contacts.push_back(contact);
    forces->surface.push_back({contact.point_w, -force_w});
  }
}

bool WheelContact::Press(int i, const TirePose& pose, const SurfacePatch& patch,
                         const PlateCurve& curve, NodeContact* contact) const {
  const Vector3d node_w = pose.centre_w + pose.frame_w * nodes_.position_t[i];
  const SurfacePoint ground = patch.At(node_w.x(), node_w.y());
  const double below = ground.height - node_w.z();
  const Vector3d radial_w = pose.frame_w * nodes_.radial_t[i];
  if (below <= 0 || radial_w.z() >= 0) return false;

  const double descent = Descent(radial_w, ground.slope_x, ground.slope_y);
  PressedPoint point;
  point.penetration = std::min(below / std::max(descent, kLeastDescent), nodes_.radius[i]);
  point.depth = ground.sinkage;
  point.release = 1;
  point.deepening =
      std::max(Descent(radial_w, ground.undisturbed_x, ground.undisturbed_y), kLeastDescent);
  const PressedState state = Equilibrium(tire_.spring, curve, point);

  contact->node = i;
  // Damped. Neither does soil pull nor does it bear more than its capacity.
  const double most =
      state.yields ? state.pressure : BearingPressure(curve.k_e, curve.n, state.depth);
  contact->pressure =
      std::clamp(state.pressure + tire_.damping * ClosingSpeed(pose, ground), 0.0, most);
  contact->area = LoadedArea(nodes_.area[i], nodes_.radius[i], state.penetration);
  contact->depth = state.depth;
  contact->point_w = node_w - state.penetration * radial_w;
  contact->normal_force_w =
      -contact->pressure * contact->area * (pose.frame_w * nodes_.normal_t[i]);
  return true;
}

void WheelContact::Rub(const TirePose& pose, const Soil& soil, double h,
                       NodeContact* contact) const {
  const int i = contact->node;
  const Vector3d tangent_w = pose.frame_w * nodes_.tangent_t[i];
  const Vector3d binormal_w = pose.frame_w * nodes_.binormal_t[i];
  const Vector3d slip_w =
      pose.velocity_w + pose.angular_velocity_w.cross(contact->point_w - pose.centre_w);
  const double v_t = slip_w.dot(tangent_w), v_b = slip_w.dot(binormal_w), K = soil.shear.modulus;
  contact->mobilisation = softsoil::Slip(mobilisation_[i], v_t, v_b, h, K);
  const double lead = ShearLead(std::hypot(v_t, v_b), K);
  const Mobilisation damped = softsoil::Slip(contact->mobilisation, v_t, v_b, lead, K);
  const double strength = ShearStrength(soil.shear, tire_.soil_friction, contact->pressure) *
                          HumpFactor(soil.shear, damped.slip);
  contact->shear_force_w =
      -strength * contact->area * (damped.t * tangent_w + damped.b * binormal_w);
}

void WheelContact::Commit(const PatchForces& forces) {
  Reset();
  for (const NodeContact& c : forces.contacts) mobilisation_[c.node] = c.mobilisation;
}

SlipMemory WheelContact::Slip() const {
  const auto has_slipped = [](const Mobilisation& m) {
    return m.t != 0 || m.b != 0 || m.slip != 0;
  };
  SlipMemory slip;
  slip.reserve(std::count_if(mobilisation_.begin(), mobilisation_.end(), has_slipped));
  for (std::size_t i = 0; i < mobilisation_.size(); ++i) {
    if (has_slipped(mobilisation_[i])) slip.push_back({static_cast<int>(i), mobilisation_[i], 0});
  }
  return slip;
}

void WheelContact::SetSlip(const SlipMemory& slip) {
  Reset();
  for (const NodeSlip& s : slip) mobilisation_[s.node] = s.mobilisation;
}

void Write(const SlipMemory& slip, StateWriter& writer) {
  writer.Put(static_cast<std::uint64_t>(slip.size()));
  for (const NodeSlip& s : slip) {
    writer.Put(s.node);
    writer.Put(s.mobilisation.t);
    writer.Put(s.mobilisation.b);
    writer.Put(s.mobilisation.slip);
    writer.Put(s.pushed);
  }
}

SlipMemory ReadSlipMemory(StateReader& reader, std::size_t nodes) {
  SlipMemory slip(reader.Count(sizeof(int) + 4 * sizeof(double)));
  for (NodeSlip& s : slip) {
    s.node = reader.Get<int>();
    reader.Require(s.node >= 0 && static_cast<std::size_t>(s.node) < nodes, "a node of a tire");
    s.mobilisation = {reader.GetFinite(), reader.GetFinite(), reader.GetFinite()};
    s.pushed = reader.GetFinite();
  }
  return slip;
}

}  // namespace softsoil
