// The C interface: the soil as state.
#include <memory>
#include <string>

#include "plugin/fence.h"
#include "plugin/host.h"
#include "plugin/softsoil.h"
#include "plugin/state_file.h"

using softsoil::EntryOf;
using softsoil::Fenced;
using softsoil::ModelData;
using softsoil::Require;
using softsoil::SoilEntry;
using softsoil::SoilOf;
using softsoil::SoilState;

struct softsoilSnapshot_ {
  SoilState state;
};

namespace {

void RequirePath(const char* path) {
  Require(path, "path");
  if (*path == '\0') throw softsoil::InputError("path must not be empty");
}

// m: of the mjData, if that is to be loaded too; else null. If it throws nothing has changed.
void Load(const mjModel* m, mjData* d, const char* path) {
  RequirePath(path);
  const std::shared_ptr<SoilEntry> entry = EntryOf(d);
  const softsoil::SoilBinding& soil = *entry->soil;
  softsoil::SavedState saved = LoadState(path, soil.soft_wheels(), soil.Undisturbed(), m);
  if (m != nullptr) softsoil::Exchange(&saved.mujoco, m, d);
  try {
    softsoil::RestoreSoil(d, saved.soil);
  } catch (...) {
    if (m != nullptr) softsoil::Exchange(&saved.mujoco, m, d);
    throw;
  }
}

}  // namespace

extern "C" {

int softsoil_copy(mjData* dst, const mjData* src) {
  return Fenced([&] {
    Require(dst, "dst");
    const std::shared_ptr<SoilEntry> from = EntryOf(src);
    if (dst == src) return;
    softsoil::CopySoil(from->fingerprint, src, SoilOf(src)->State(src), dst);
  });
}

softsoilSnapshot* softsoil_snapshot(const mjData* d) {
  softsoilSnapshot* snapshot = nullptr;
  Fenced([&] { snapshot = new softsoilSnapshot{SoilOf(d)->State(d)}; });
  return snapshot;
}

int softsoil_restore(mjData* d, const softsoilSnapshot* snapshot) {
  return Fenced([&] {
    Require(snapshot, "snapshot");
    Require(d, "mjData");
    softsoil::RestoreSoil(d, snapshot->state);
  });
}

void softsoil_free_snapshot(softsoilSnapshot* snapshot) { delete snapshot; }

int softsoil_save(const mjData* d, const char* path) {
  return Fenced([&] {
    RequirePath(path);
    softsoil::SaveState(path, SoilOf(d)->State(d), nullptr);
  });
}

int softsoil_load(mjData* d, const char* path) {
  return Fenced([&] { Load(nullptr, d, path); });
}

int softsoil_save_simulation(const mjModel* m, const mjData* d, const char* path) {
  return Fenced([&] {
    RequirePath(path);
    EntryOf(m, d);
    const ModelData data{m, d};
    softsoil::SaveState(path, SoilOf(d)->State(d), &data);
  });
}

int softsoil_load_simulation(const mjModel* m, mjData* d, const char* path) {
  return Fenced([&] {
    EntryOf(m, d);
    Load(m, d, path);
  });
}

int softsoil_hash(const mjData* d, uint64_t* hash) {
  return Fenced([&] {
    Require(hash, "hash");
    softsoil::StateWriter writer;
    Write(SoilOf(d)->State(d), writer);
    *hash = writer.Finish();
  });
}

}  // extern "C"
