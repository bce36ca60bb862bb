#include "plugin/fence.h"

#include <stdexcept>

namespace softsoil {

std::string& LastError() {
  thread_local std::string message;
  return message;
}

std::shared_ptr<SoilEntry> EntryOf(const mjData* d) {
  Require(d, "mjData");
  std::shared_ptr<SoilEntry> entry = Registry::Get().Find(d);
  const bool is_of_this = entry != nullptr && entry->fingerprint.buffer == d->buffer;
  if (is_of_this && entry->soil != nullptr) return entry;
  if (is_of_this && !entry->lost_because.empty()) {
    throw std::runtime_error("this mjData has lost its soil: " + entry->lost_because);
  }
  throw InputError("this mjData has no soil: call softsoil_attach() first");
}

std::shared_ptr<SoilEntry> EntryOf(const mjModel* m, const mjData* d) {
  Require(m, "mjModel");
  std::shared_ptr<SoilEntry> entry = EntryOf(d);
  if (entry->fingerprint == FingerprintOf(m, d)) return entry;
  throw InputError("this mjData has no soil for this mjModel: call softsoil_attach() first");
}

std::shared_ptr<SoilBinding> SoilOf(const mjData* d) {
  const std::shared_ptr<SoilEntry> entry = EntryOf(d);
  if (entry->lost_because.empty()) entry->soil->FollowMark(d);
  return {entry, entry->soil.get()};
}

std::shared_ptr<SoilBinding> RunningSoilOf(const mjData* d) {
  const std::string lost_because = EntryOf(d)->lost_because;
  if (!lost_because.empty()) {
    throw std::runtime_error("this mjData has lost its soil: " + lost_because);
  }
  return SoilOf(d);
}

}  // namespace softsoil
