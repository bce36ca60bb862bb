#include "contact/wheel_contact.h"

#include <algorithm>
#include <cmath>

#include "contact/flank.h"
#include "contact/node_laws.h"
#include "contact/tread_strength.h"

namespace softsoil {
namespace {

using Eigen::Vector3d;

// The part of the surface that a wheel can reach, its bounding box, and one node around.
void CopyFootprint(const TireShape& shape, const TirePose& pose, const Surface& surface,
                   SurfacePatch* patch) {
  const Vector3d axis = pose.frame_w.col(1);
  const auto half_extent = [&](int k) {
    return shape.radius * std::sqrt(std::max(0.0, 1 - axis[k] * axis[k])) +
           shape.width / 2 * std::abs(axis[k]) + surface.spacing();
  };
  const Vector3d& c = pose.centre_w;
  surface.CopyPatch(c.x() - half_extent(0), c.x() + half_extent(0), c.y() - half_extent(1),
                    c.y() + half_extent(1), patch);
}

// How far [m] the soil has given way, along the radius of the wheel, where the lug tips have been
// at a depth [m].
double GivenWay(const PressedPoint& point, double depth) {
  return std::max(0.0, (depth - point.depth) / point.deepening);
}

}  // namespace

Wrench About(const Wrench& wrench, const Vector3d& at_w) {
  return {wrench.force_w, wrench.torque_w + (wrench.at_w - at_w).cross(wrench.force_w), at_w};
}

WheelContact::WheelContact(const Tire& tire, double node_spacing)
    : tire_(tire), nodes_(MakeTireNodes(tire.shape, node_spacing)) {
  Reset();
}

void WheelContact::Reset() {
  mobilisation_.assign(nodes_.size(), {0, 0});
  deepest_.assign(nodes_.on_lug.size(), 0);
}

void WheelContact::Evaluate(const TirePose& pose, const Surface& surface, const SoilMap& soils,
                            double h, PatchForces* forces) const {
  RequireUsable(pose);
  CopyFootprint(tire_.shape, pose, surface, &forces->patch);
  forces->wrench = Wrench{};
  forces->wrench.at_w = pose.centre_w;
  forces->contacts.clear();
  forces->surface.clear();
  const Vector3d up_t = pose.frame_w.row(2);
  TreadCurves curves(soils, tire_.shape);
  const double highest = forces->patch.highest() - pose.centre_w.z();
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    if (nodes_.position_t[i].dot(up_t) >= highest) continue;
    NodeContact contact{};
    if (!Press(static_cast<int>(i), pose, forces->patch, &curves, &contact)) continue;
    Mobilise(pose, h, soils[contact.soil].shear.modulus, &contact);
    forces->contacts.push_back(contact);
  }
  FillStrength(tire_, nodes_, soils, &forces->contacts);
  for (NodeContact& contact : forces->contacts) {
    const Soil& soil = soils[contact.soil];
    contact.slip_sinkage = SlipSinkageOf(contact, curves.In(contact.soil), soil);
    contact.shear_force_w = ShearForce(pose, soil.shear, contact);
    contact.flank_force_w.setZero();
    const Vector3d force_w = contact.normal_force_w + contact.shear_force_w;
    forces->wrench.force_w += force_w;
    forces->wrench.torque_w += (contact.point_w - pose.centre_w).cross(force_w);
    forces->surface.push_back({contact.point_w, -force_w, contact.slip_sinkage * contact.area});
  }
  PushFlanks(nodes_, pose, soils, forces);
}

bool WheelContact::Press(int i, const TirePose& pose, const SurfacePatch& patch,
                         TreadCurves* curves, NodeContact* contact) const {
  const Vector3d node_w = pose.centre_w + pose.frame_w * nodes_.position_t[i];
  const SurfacePoint ground = patch.At(node_w.x(), node_w.y());
  const double below = ground.height - node_w.z();
  const Vector3d radial_w = pose.frame_w * nodes_.radial_t[i];
  if (below <= 0 || radial_w.z() >= 0) return false;

  const double descent = Descent(radial_w, ground.slope_x, ground.slope_y);
  PressedPoint point;
  point.penetration = std::min(below / std::max(descent, kLeastDescent), nodes_.radius[i]);
  point.depth = ground.sinkage - ground.slip_sinkage;
  point.loose = ground.loose;
  point.release = 1;
  point.deepening =
      std::max(Descent(radial_w, ground.undisturbed_x, ground.undisturbed_y), kLeastDescent);
  contact->node = i;
  contact->soil = curves->soils().NumberAt(node_w.x(), node_w.y());
  double lifted = 0;  // [m]  off the ground below the tips
  if (const Lugs& lugs = tire_.shape.lugs) {
    const double deepest = deepest_[i] - ground.slip_sinkage;
    const double given_way = GivenWay(point, std::min(deepest, point.depth + lugs.height));
    lifted = std::max(0.0, given_way - point.penetration);
    point.penetration = std::max(0.0, point.penetration - given_way);
    point.depth += point.deepening * given_way;
  }
  const TreadCurve& curve = curves->In(contact->soil);
  const double penetration =
      Balance(curve, point, tire_.damping * ClosingSpeed(pose, ground), contact);
  contact->depth += ground.slip_sinkage;
  contact->engaged = std::clamp(contact->depth, 0.0, tire_.shape.lugs.height) - lifted;
  contact->area = LoadedArea(nodes_.area[i], nodes_.radius[i], penetration);
  contact->point_w = node_w - penetration * radial_w;
  contact->normal_force_w =
      -contact->pressure * contact->area * (pose.frame_w * nodes_.normal_t[i]);
  return true;
}

double WheelContact::Balance(const TreadCurve& curve, const PressedPoint& point, double damping,
                             NodeContact* contact) const {
  const TreadState state = Equilibrium(tire_.spring, curve, point);
  // Damped. Neither does soil pull nor does it bear more than its capacity.
  const double most = state.yields ? state.pressure : BearingPressure(curve, state.depth);
  contact->pressure = std::clamp(state.pressure + damping, 0.0, most);
  contact->depth = state.depth;
  contact->tread_pressure = contact->pressure;
  if (tire_.shape.lugs && state.pressure > 0) {
    contact->pressure *=
        (nodes_.on_lug[contact->node] ? state.on_lugs : state.between_lugs) / state.pressure;
  }
  return state.penetration;
}

void WheelContact::Mobilise(const TirePose& pose, double h, double K, NodeContact* contact) const {
  const int i = contact->node;
  const Vector3d slip_w =
      pose.velocity_w + pose.angular_velocity_w.cross(contact->point_w - pose.centre_w);
  const double v_t = slip_w.dot(pose.frame_w * nodes_.tangent_t[i]);
  const double v_b = slip_w.dot(pose.frame_w * nodes_.binormal_t[i]);
  contact->mobilisation = softsoil::Slip(mobilisation_[i], v_t, v_b, h, K);
  const double lead = ShearLead(std::sqrt(v_t * v_t + v_b * v_b), K);
  contact->mobilised = softsoil::Slip(contact->mobilisation, v_t, v_b, lead, K);
}

// By the strength of rubber on soil also between lugs: cohesion under no pressure would sink
// without end.
double WheelContact::SlipSinkageOf(const NodeContact& c, const TreadCurve& curve,
                                   const Soil& soil) const {
  if (soil.slip_sinkage == 0 || c.tread_pressure <= 0) return 0;
  const double strength = ShearStrength(soil.shear, tire_.soil_friction, c.tread_pressure);
  const double way = c.mobilisation.slip - mobilisation_[c.node].slip;
  return SlipSinkage(soil.slip_sinkage, strength / BearingPressure(curve, c.depth), c.mobilisation,
                     way);
}

Vector3d WheelContact::ShearForce(const TirePose& pose, const Shear& soil,
                                  const NodeContact& contact) const {
  const Vector3d tangent_w = pose.frame_w * nodes_.tangent_t[contact.node];
  const Vector3d binormal_w = pose.frame_w * nodes_.binormal_t[contact.node];
  const Mobilisation& m = contact.mobilised;
  const double strength = contact.strength * HumpFactor(soil, m.slip);
  Vector3d force_w = -strength * contact.area * (m.t * tangent_w + m.b * binormal_w);
  if (contact.side_strength > 0) force_w -= contact.side_strength * m.t * tangent_w;
  return force_w;
}

void WheelContact::Commit(const PatchForces& forces) {
  mobilisation_.assign(nodes_.size(), {0, 0});
  for (const NodeContact& c : forces.contacts) mobilisation_[c.node] = c.mobilisation;
  if (deepest_.empty()) return;
  int next = 0;
  for (const NodeContact& c : forces.contacts) {
    std::fill(deepest_.begin() + next, deepest_.begin() + c.node, 0);
    deepest_[c.node] = std::max(deepest_[c.node], c.depth);
    next = c.node + 1;
  }
  std::fill(deepest_.begin() + next, deepest_.end(), 0);
}

SlipMemory WheelContact::Slip() const {
  const auto deepest = [this](std::size_t i) { return deepest_.empty() ? 0 : deepest_[i]; };
  const auto remembers = [&](std::size_t i) {
    const Mobilisation& m = mobilisation_[i];
    return m.t != 0 || m.b != 0 || m.slip != 0 || deepest(i) != 0;
  };
  SlipMemory slip;
  std::size_t count = 0;
  for (std::size_t i = 0; i < mobilisation_.size(); ++i) count += remembers(i);
  slip.reserve(count);
  for (std::size_t i = 0; i < mobilisation_.size(); ++i) {
    if (remembers(i)) slip.push_back({static_cast<int>(i), mobilisation_[i], deepest(i)});
  }
  return slip;
}

void WheelContact::SetSlip(const SlipMemory& slip) {
  Reset();
  for (const NodeSlip& s : slip) {
    mobilisation_[s.node] = s.mobilisation;
    if (!deepest_.empty()) deepest_[s.node] = s.deepest;
  }
}

}  // namespace softsoil
