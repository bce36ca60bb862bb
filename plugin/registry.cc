#include "plugin/registry.h"

#include <array>
#include <utility>

namespace softsoil {
namespace {

// What a thread found last at an address. Keeps no soil alive.
struct Found {
  const mjData* data = nullptr;
  std::uint64_t changes = 0;  // of the registry until then
  std::weak_ptr<SoilEntry> entry;
};

// Trivial, unlike the memory itself: a host may step until the very end of the process.
thread_local bool memory_is_gone = false;

struct Memory {
  std::array<Found, 8> found;
  ~Memory() { memory_is_gone = true; }
};

// Where this thread remembers what it finds for a mjData, null while it ends. Neighbours in memory
// have places of their own.
Found* Remembered(const mjData* d) {
  if (memory_is_gone) return nullptr;
  thread_local Memory memory;
  return &memory.found[reinterpret_cast<std::uintptr_t>(d) / sizeof(mjData) % memory.found.size()];
}

}  // namespace

Fingerprint FingerprintOf(const mjModel* m, const mjData* d) {
  return {m, d->buffer, ContentOf(m)};
}

Registry& Registry::Get() {
  static auto* const registry = new Registry;
  return *registry;
}

std::shared_ptr<SoilEntry> Registry::Find(const mjData* d) const {
  Found* const last = Remembered(d);
  if (last != nullptr && last->data == d && last->changes == changes_) return last->entry.lock();
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto it = entries_.find(d);
  std::shared_ptr<SoilEntry> entry = it == entries_.end() ? nullptr : it->second;
  if (last != nullptr) *last = {d, changes_, entry};
  return entry;
}

void Registry::Put(const mjData* d, std::shared_ptr<SoilEntry> entry) {
  const std::lock_guard<std::mutex> lock(mutex_);
  std::swap(entries_[d], entry);  // the old one dies after the lock is released
  ++changes_;
}

std::shared_ptr<SoilEntry> Registry::Erase(const void* d) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto it = entries_.find(d);
  if (it == entries_.end()) return nullptr;
  std::shared_ptr<SoilEntry> erased = std::move(it->second);
  entries_.erase(it);
  ++changes_;
  return erased;
}

}  // namespace softsoil
