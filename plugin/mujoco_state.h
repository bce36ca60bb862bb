// The state of a mjData as bytes: all that MuJoCo's future depends on. MuJoCo 2.2 has no function
// for it.
#pragma once

#include <mujoco/mujoco.h>

#include <vector>

#include "terrain/state_stream.h"

namespace softsoil {

// Time, positions, velocities, activations, controls, applied forces, mocap poses, the user's data
// and the warm start of the solver. So many numbers at the end of userdata are written as 0.
void Write(const mjModel* m, const mjData* d, int cleared_userdata, StateWriter& writer);

using MujocoState = std::vector<std::vector<mjtNum>>;

// What Write() wrote, of a model with the same names and sizes. Throws InputError.
MujocoState ReadMujocoState(StateReader& reader, const mjModel* m);

// The mjData is in this state, and `state` is that in which it was. Cannot fail.
void Exchange(MujocoState* state, const mjModel* m, mjData* d);

}  // namespace softsoil
