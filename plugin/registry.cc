#include "plugin/registry.h"

#include <functional>
#include <string_view>
#include <utility>

namespace softsoil {
namespace {

template <class T>
std::size_t Hash(const T* data, int count, std::size_t seed) {
  const auto* bytes = reinterpret_cast<const char*>(data);
  const std::string_view view(bytes, count * sizeof(T));
  return seed * 31 + std::hash<std::string_view>()(view);
}

}  // namespace

Fingerprint FingerprintOf(const mjModel* m, const mjData* d) {
  std::size_t content = Hash(m->names, m->nnames, 0);
  content = Hash(m->text_data, m->ntextdata, content);
  content = Hash(m->numeric_data, m->nnumericdata, content);
  content = Hash(m->tuple_objid, m->ntupledata, content);
  return {m, d->buffer, content};
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
