#include "plugin/mujoco_state.h"

#include <algorithm>
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

std::vector<Array> ArraysOf(const mjModel* m, mjData* d) {
  return {{"time", &d->time, 1},
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
          {kUserdata, d->userdata, m->nuserdata}};
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

void Read(StateReader& reader, const mjModel* m, mjData* d) {
  if (reader.GetText() != NamesOf(m)) {
    throw InputError("the state is of another model: the names in it differ");
  }
  const std::vector<Array> arrays = ArraysOf(m, d);
  std::vector<std::vector<mjtNum>> values;
  for (const Array& array : arrays) {
    values.push_back(reader.GetAll<mjtNum>());
    const int count = static_cast<int>(values.back().size());
    if (count == array.count) continue;
    throw InputError("the state is of another model: it has " + std::to_string(count) +
                     " numbers of " + array.name + ", the model " + std::to_string(array.count));
  }
  for (std::size_t i = 0; i < arrays.size(); ++i) {
    std::copy(values[i].begin(), values[i].end(), arrays[i].values);
  }
}

}  // namespace softsoil
