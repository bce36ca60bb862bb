// The contact of a shape of triangles with soft ground: a lugged tire, a rigid wheel with grousers,
// a track shoe, a plate, a blade. Like WheelContact, force is a question and history an event.
#pragma once

#include <vector>

#include "contact/wheel_contact.h"

namespace softsoil {

// Every node presses with
//   n_z^2 p + (1 - n_z^2) s sigma_p,  n its outward normal,
// as the normal stress on an inclined plane between a vertical stress, the bearing pressure p of a
// face that looks down, and a horizontal one, the passive earth pressure sigma_p (2.74) of a face
// that is driven sideways into the soil before it. p is that of a tire node whose radius is its
// normal. s is the share of the passive pressure that the way of the node into the soil has
// mobilised, 1 - exp(-j/K) from rest as that of shear; it unloads when the face draws back. A face
// that looks up bears nothing.
//
// A rigid shape is one whose spring is stiff: the soil then gives all the way and the pressure is
// its bearing capacity. The spring only decides how soon the force falls as the shape is lifted,
// and so how short the time step must be.
class MeshContact {
 public:
  // A tire with a mesh. node_spacing [m] > 0.
  MeshContact(const Tire& tire, double node_spacing);

  const Tire& tire() const { return tire_; }
  const TireNodes& nodes() const { return nodes_; }

  void Evaluate(const TirePose& pose, const Surface& surface, const SoilMap& soils, double h,
                PatchForces* forces) const;
  void Commit(const PatchForces& forces);

  SlipMemory Slip() const;
  void SetSlip(const SlipMemory& slip);
  void Reset();

 private:
  struct Question;
  // False if the node does not touch the ground.
  bool Press(int node, Question* question, NodeContact* contact) const;
  double BearingShare(int node, const Question& question, const SurfacePoint& ground,
                      NodeContact* contact) const;
  void Rub(const Question& question, NodeContact* contact) const;
  double SlipSinkageOf(const Question& question, const NodeContact& contact) const;

  Tire tire_;
  TireNodes nodes_;
  std::vector<NodeSlip> memory_;  // by node
};

}  // namespace softsoil
