#include "plugin/registry.h"

#include <utility>

namespace softsoil {

Fingerprint FingerprintOf(const mjModel* m, const mjData* d) {
  return {m, d->buffer, ContentOf(m)};
}

Registry& Registry::Get() {
  static auto* const registry = new Registry;
  return *registry;
}

std::shared_ptr<SoilEntry> Registry::Find(const mjData* d) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto it = entries_.find(d);
  return it == entries_.end() ? nullptr : it->second;
}

void Registry::Put(const mjData* d, std::shared_ptr<SoilEntry> entry) {
  const std::lock_guard<std::mutex> lock(mutex_);
  std::swap(entries_[d], entry);  // the old one dies after the lock is released
}

std::shared_ptr<SoilEntry> Registry::Erase(const void* d) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto it = entries_.find(d);
  if (it == entries_.end()) return nullptr;
  std::shared_ptr<SoilEntry> erased = std::move(it->second);
  entries_.erase(it);
  return erased;
}

}  // namespace softsoil
