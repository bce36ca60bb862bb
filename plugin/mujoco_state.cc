#include "plugin/mujoco_state.h"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "terrain/input_error.h"

namespace softsoil {
namespace {

constexpr char kUserdata[] = "userdata";

struct Array {
  const char* name;
  mjtNum* values;
  int count;
};

std::array<Array, 12> ArraysOf(const mjModel* m, mjData* d) {
  return {{{"time", &d->time, 1},
           {"qpos", d->qpos, m->nq},
           {"qvel", d->qvel, m->nv},
           {"act", d->act, m->na},
           {"qacc_warmstart", d->qacc_warmstart, m->nv},
           {"ctrl", d->ctrl, m->nu},
           {"qfrc_applied", d->qfrc_applied, m->nv},
           {"xfrc_applied", d->xfrc_applied, 6 * m->nbody},
           {"qacc", d->qacc, m->nv},
           {"mocap_pos", d->mocap_pos, 3 * m->nmocap},
           {"mocap_quat", d->mocap_quat, 4 * m->nmocap},
           {kUserdata, d->userdata, m->nuserdata}}};
}

std::string NamesOf(const mjModel* m) {
  return std::string(m->names, static_cast<std::size_t>(m->nnames));
}

}  // namespace

void Write(const mjModel* m, const mjData* d, int cleared_userdata, StateWriter& writer) {
  writer.PutText(NamesOf(m));
  for (const Array& array : ArraysOf(m, const_cast<mjData*>(d))) {  // read alone
    std::vector<mjtNum> values(array.values, array.values + array.count);
    if (array.name == kUserdata) std::fill_n(values.rbegin(), cleared_userdata, 0);
    writer.PutAll(values);
  }
}

MujocoState ReadMujocoState(StateReader& reader, const mjModel* m) {
  if (reader.GetText() != NamesOf(m)) {
    throw InputError("the state is of another model: the names in it differ");
  }
  MujocoState state;
  mjData no_data = {};  // for the names and sizes alone
  for (const Array& array : ArraysOf(m, &no_data)) {
    state.push_back(reader.GetAll<mjtNum>());
    const int count = static_cast<int>(state.back().size());
    if (count == array.count) continue;
    throw InputError("the state is of another model: it has " + std::to_string(count) +
                     " numbers of " + array.name + ", the model " + std::to_string(array.count));
  }
  return state;
}

void Exchange(MujocoState* state, const mjModel* m, mjData* d) {
  const std::array<Array, 12> arrays = ArraysOf(m, d);
  for (std::size_t i = 0; i < arrays.size(); ++i) {
    std::swap_ranges((*state)[i].begin(), (*state)[i].end(), arrays[i].values);
  }
}

}  // namespace softsoil
