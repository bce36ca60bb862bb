#include "plugin/motion_state.h"

#include <algorithm>
#include <cmath>

namespace softsoil {
namespace {

// To the bit, but quaternions to rounding: MuJoCo normalizes them where they are evaluated, but not
// again where it skips the evaluation of positions.
bool IsSamePosition(int type, const mjtNum* now, const double* then) {
  constexpr double kRounding = 1e-14;
  const int translations = type == mjJNT_FREE ? 3 : type == mjJNT_BALL ? 0 : 1;
  const int quaternions = type == mjJNT_FREE || type == mjJNT_BALL ? 4 : 0;
  const auto near = [](double a, double b) { return std::abs(a - b) < kRounding; };
  return std::equal(now, now + translations, then) &&
         std::equal(now + translations, now + translations + quaternions, then + translations,
                    near);
}

// The value that a velocity adds to. Rotations of free and ball joints add to unit quaternions.
double PositionOf(const mjModel* m, const mjData* d, int dof) {
  const int joint = m->dof_jntid[dof], type = m->jnt_type[joint];
  const int k = dof - m->jnt_dofadr[joint];
  if (type == mjJNT_BALL || (type == mjJNT_FREE && k > 2)) return 1;
  return d->qpos[m->jnt_qposadr[joint] + k];
}

}  // namespace

void CopyMotion(const mjData* d, const mjModel* m, MotionState* state) {
  state->qpos.assign(d->qpos, d->qpos + m->nq);
  state->qvel.assign(d->qvel, d->qvel + m->nv);
}

MotionChange ChangeOfMotion(const MotionState& before, const mjModel* m, const mjData* d) {
  MotionChange change;
  for (int joint = 0; joint < m->njnt; ++joint) {
    const int k = m->jnt_qposadr[joint];
    if (!IsSamePosition(m->jnt_type[joint], d->qpos + k, &before.qpos[k])) ++change.joints;
  }
  for (int dof = 0; dof < m->nv; ++dof) {
    if (d->qvel[dof] == before.qvel[dof]) continue;
    ++change.velocities;
    change.dof = dof;
  }
  return change;
}

bool IsHeldBack(const MotionState& before, const mjData* d, int dof, double h) {
  for (int k = 0; k < static_cast<int>(before.qvel.size()); ++k) {
    const double v = before.qvel[k];
    if (k != dof && d->qvel[k] == v && v + h * d->qacc[k] != v) return true;
  }
  return false;
}

bool Moves(const mjModel* m, const mjData* d, double h) {
  for (int dof = 0; dof < m->nv; ++dof) {
    const double position = PositionOf(m, d, dof);
    if (position + h * d->qvel[dof] != position) return true;
  }
  return false;
}

}  // namespace softsoil
