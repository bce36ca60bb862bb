// What a wheel remembers of its contact.
#pragma once

#include <vector>

#include "terrain/shear.h"
#include "terrain/state_stream.h"

namespace softsoil {

// One node on the ground: the shear that its slip has mobilised; of a tire with lugs, how deep the
// tips of the lugs have been around it since the contact began; of a mesh, the share of the passive
// pressure that its way into the soil has mobilised.
struct NodeSlip {
  int node;  // of TireNodes
  Mobilisation mobilisation;
  double deepest = 0;  // [m]  below the undisturbed ground, 0 without lugs
  double pushed = 0;   // [-]  0 without a mesh
};
// In the order of the nodes. A node that is not listed has nothing to remember.
using SlipMemory = std::vector<NodeSlip>;

void Write(const SlipMemory& slip, StateWriter& writer);
// Of a tire of `nodes` nodes. Throws InputError.
SlipMemory ReadSlipMemory(StateReader& reader, std::size_t nodes);

}  // namespace softsoil
