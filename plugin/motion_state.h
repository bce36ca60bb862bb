// Positions and velocities at an evaluation, and what a later state tells about them: whether the
// model has moved on, or was put back to be tried once more.
#pragma once

#include <mujoco/mujoco.h>

#include <vector>

namespace softsoil {

struct MotionState {
  std::vector<double> qpos, qvel;
};

void CopyMotion(const mjData* d, const mjModel* m, MotionState* state);

// How the state of a mjData differs from an earlier one.
struct MotionChange {
  int joints = 0;      // whose position is another
  int velocities = 0;  // entries of qvel
  int dof = -1;        // the last of these entries, -1 if there is none
};
MotionChange ChangeOfMotion(const MotionState& before, const mjModel* m, const mjData* d);

// Whether a velocity other than that of `dof` is the earlier one to the bit, although the last
// acceleration would have changed it within h [s]. No integrator leaves it so: the host has put
// it back.
bool IsHeldBack(const MotionState& before, const mjData* d, int dof, double h);

// Whether a joint leaves its position within h [s] at the velocity that it has.
bool Moves(const mjModel* m, const mjData* d, double h);

}  // namespace softsoil
