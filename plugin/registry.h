// Which mjData has which soil.
#pragma once

#include <mujoco/mujoco.h>

#include <atomic>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "plugin/soil_binding.h"

namespace softsoil {

// Tells models and mjData apart whose addresses are the same: MuJoCo reuses them at once after a
// free, and mj_loadXML steps a mjData of its own. Copies of a model are one model.
struct Fingerprint {
  const mjModel* model;  // by which the mjData was last used
  const void* buffer;    // of mjData
  std::size_t content;   // hash of names, sizes and <custom> of the model

  bool operator==(const Fingerprint& other) const {
    return buffer == other.buffer && content == other.content;
  }
};
Fingerprint FingerprintOf(const mjModel* m, const mjData* d);

struct SoilEntry {
  Fingerprint fingerprint;
  std::unique_ptr<SoilBinding> soil;  // null: this mjData goes without
  std::string lost_because;           // why it goes without; what soil there is rests; else empty
};

// For all threads. An entry is used by the thread that steps its mjData, without any lock; each
// thread remembers what it found last, until entries are put or erased.
class Registry {
 public:
  // Never destroyed: a host may step until the very end of the process.
  static Registry& Get();

  // Null where there is none.
  std::shared_ptr<SoilEntry> Find(const mjData* d) const;
  // In place of the one that was there.
  void Put(const mjData* d, std::shared_ptr<SoilEntry> entry);
  // Takes the entry out, null if there is none. Any address will do.
  std::shared_ptr<SoilEntry> Erase(const void* d);

 private:
  Registry() = default;  // the one: what threads remember does not tell registries apart

  mutable std::mutex mutex_;
  std::map<const void*, std::shared_ptr<SoilEntry>> entries_;
  std::atomic<std::uint64_t> changes_{0};  // of entries_; written with the mutex held
};

}  // namespace softsoil
