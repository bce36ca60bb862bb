#include "plugin/host.h"

#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <mutex>
#include <string>
#include <utility>

#include "plugin/failure.h"
#include "plugin/fence.h"
#include "plugin/log.h"
#include "plugin/mujoco_symbols.h"
#include "plugin/out_of_memory.h"
#include "plugin/rigid_contact.h"
#include "plugin/soil_history.h"
#include "terrain/input_error.h"

namespace softsoil {
namespace {

// Trivially destructible: callbacks come until the very end of the process.
struct Host {
  MujocoSymbols mujoco;
  mjfGeneric earlier_passive = nullptr;
  mjfConFilt earlier_filter = nullptr;
  void (*earlier_free)(void*) = nullptr;
  bool notices_free = false;
  std::atomic<bool> learns_models{false};
  OnError on_error = OnError::kContinue;
};
Host host;

std::mutex& InstallMutex() {
  static auto* const mutex = new std::mutex;
  return *mutex;
}

void OnPassive(const mjModel* m, mjData* d);
void InstallContactFilter();

std::unique_ptr<SoilBinding> MakeSoil(std::shared_ptr<const SoilPlan> plan) {
  if (plan->remove_rigid_contact) InstallContactFilter();
  return std::make_unique<SoilBinding>(std::move(plan));
}

// A host that sets mjcb_passive after us should call ours. Whether it did is known in the end.
void WarnIfPassedOver(const SoilBinding& soil, const mjData* d) {
  if (*host.mujoco.passive == &OnPassive || !soil.WasPassedOver(d->time)) return;
  Say("warning: the program has set an mjcb_passive of its own, which does not call the one that "
      "was there: steps went by without soft soil");
}

// Soil that was there takes its forces along.
void PutEntry(const Fingerprint& fingerprint, mjData* d, std::unique_ptr<SoilBinding> soil,
              const std::string& lost_because = "") {
  auto entry = std::make_shared<SoilEntry>();
  entry->fingerprint = fingerprint;
  entry->soil = std::move(soil);
  entry->lost_because = lost_because;
  const std::shared_ptr<SoilEntry> old = Registry::Get().Find(d);
  if (old != nullptr && old->soil != nullptr && old->fingerprint == entry->fingerprint) {
    old->soil->RemoveForces(d);
    WarnIfPassedOver(*old->soil, d);
  }
  Registry::Get().Put(d, std::move(entry));
}

// What becomes of a failure in the middle of a step. The soil rests as it is: it can still be asked
// and saved.
void Answer(const Failure& failure, const mjModel* m, mjData* d) {
  if (host.on_error == OnError::kStop) {
    Stop(failure, *host.mujoco.user_error);
    return;
  }
  const std::shared_ptr<SoilEntry> entry = Registry::Get().Find(d);
  const bool is_known = entry != nullptr && entry->fingerprint == FingerprintOf(m, d);
  if (is_known && entry->soil != nullptr) entry->soil->RemoveForces(d);
  if (is_known) Keep(failure.message, &entry->lost_because);
  try {
    if (!is_known) PutEntry(FingerprintOf(m, d), d, nullptr, failure.message);
    Say(std::string(failure.message) + "; the model runs without soft soil");
  } catch (const std::bad_alloc&) {
    std::fprintf(stderr, "softsoil: %s; the model runs without soft soil\n", kOutOfMemory);
  }
}

// The soil that the model asks for, null if it asks for none.
std::unique_ptr<SoilBinding> SoilThatModelWants(const mjModel* m) {
  const Settings settings = SettingsOf(m);
  if (!settings.soil.empty()) return MakeSoil(std::make_shared<SoilPlan>(MakePlan(m, settings)));
  Say("model \"" + std::string(m->names) +
      "\" names no soil (<custom> <text name=\"softsoil_soil\">): it runs without");
  return nullptr;
}

// The entry of a mjData, null if it has none. Learns the model if that is wanted.
std::shared_ptr<SoilEntry> EntryFor(const mjModel* m, const mjData* d, Failure* failure) {
  std::shared_ptr<SoilEntry> entry = Registry::Get().Find(d);
  if (entry != nullptr || !host.learns_models) return entry;
  entry = std::make_shared<SoilEntry>();
  entry->fingerprint = FingerprintOf(m, d);
  Registry::Get().Put(d, entry);
  try {
    entry->soil = SoilThatModelWants(m);
  } catch (const std::exception& error) {
    Note(error, failure);
  }
  return entry;
}

// A mjData without soil that was copied from one with soil, as its userdata tells, gets a soil of
// its own. Null if it was not.
std::shared_ptr<SoilEntry> CopiedEntry(const mjModel* m, mjData* d) {
  if (!HasRoomForMark(m->nuserdata) || !MarkIn(m->nuserdata, d).IsPossible()) return nullptr;
  const std::shared_ptr<const SoilState> state = StateMarked(MarkIn(m->nuserdata, d));
  if (state->plan->model_content != ContentOf(m)) return nullptr;
  PutEntry(FingerprintOf(m, d), d, MakeSoil(state->plan));
  return Registry::Get().Find(d);  // its first step follows the mark
}

// The fence: no exception gets past it.
void ApplySoil(const mjModel* m, mjData* d, Failure* failure) {
  try {
    std::shared_ptr<SoilEntry> entry = EntryFor(m, d, failure);
    if (entry != nullptr && !(entry->fingerprint == FingerprintOf(m, d))) {
      Registry::Get().Erase(d);
      if (!host.learns_models && entry->soil != nullptr)
        Say("a mjData with soil was deleted without softsoil_detach()");
      entry = EntryFor(m, d, failure);
    }
    if (entry == nullptr) entry = CopiedEntry(m, d);
    if (entry == nullptr || entry->soil == nullptr || !entry->lost_because.empty()) return;
    entry->fingerprint.model = m;
    entry->soil->OnPassive(m, d);
  } catch (const std::exception& error) {
    Note(error, failure);
  }
}

void OnPassive(const mjModel* m, mjData* d) {
  if (host.earlier_passive != nullptr) host.earlier_passive(m, d);
  Failure failure;
  ApplySoil(m, d, &failure);
  if (failure.happened) Answer(failure, m, d);
}

// Asked for very many contacts.
bool IsOf(const SoilEntry& entry, const mjModel* m, const mjData* d) {
  if (entry.fingerprint.model == m) return entry.fingerprint.buffer == d->buffer;
  return entry.fingerprint == FingerprintOf(m, d);
}

bool SoilDiscards(const mjModel* m, const mjData* d, int geom1, int geom2, Failure* failure) {
  try {
    const std::shared_ptr<SoilEntry> entry = EntryFor(m, d, failure);
    return entry != nullptr && entry->soil != nullptr && IsOf(*entry, m, d) &&
           entry->soil->RemovesContact(geom1, geom2);
  } catch (const std::exception& error) {
    Note(error, failure);
    return false;
  }
}

// MuJoCo's rule: non-zero discards the contact. Called for very many pairs; few are with planes.
int OnContactFilter(const mjModel* m, mjData* d, int geom1, int geom2) {
  const bool discarded = host.earlier_filter != nullptr
                             ? host.earlier_filter(m, d, geom1, geom2) != 0
                             : !MayCollide(m, geom1, geom2);
  if (discarded) return 1;
  if (m->geom_type[geom1] != mjGEOM_PLANE && m->geom_type[geom2] != mjGEOM_PLANE) return 0;
  Failure failure;
  const bool discards = SoilDiscards(m, d, geom1, geom2, &failure);
  if (failure.happened) Answer(failure, m, d);
  return discards ? 1 : 0;
}

void OnFree(void* memory) {
  const std::shared_ptr<SoilEntry> entry = Registry::Get().Erase(memory);
  try {
    if (entry != nullptr && entry->soil != nullptr) {
      WarnIfPassedOver(*entry->soil, static_cast<const mjData*>(memory));
    }
  } catch (const std::bad_alloc&) {  // then there is no warning
  }
  if (host.earlier_free != nullptr) {
    host.earlier_free(memory);
  } else {
    std::free(memory);  // as MuJoCo does on Linux
  }
}

// Puts `ours` into a variable of MuJoCo's. A host that replaced it later is left alone: it may
// well call ours.
template <class Callback>
void Install(Callback* variable, Callback ours, Callback* earlier, bool installed_before) {
  if (*variable == ours || (installed_before && *variable != nullptr)) return;
  *earlier = *variable;
  *variable = ours;
}

void InstallContactFilter() {
  const std::lock_guard<std::mutex> lock(InstallMutex());
  static bool installed = false;
  Install(host.mujoco.contact_filter, &OnContactFilter, &host.earlier_filter, installed);
  installed = true;
}

// A host with an allocator of its own but no way to free is left alone.
void InstallFreeNotice() {
  if (*host.mujoco.user_malloc != nullptr && *host.mujoco.user_free == nullptr) return;
  Install(host.mujoco.user_free, &OnFree, &host.earlier_free, host.notices_free);
  host.notices_free = true;
}

}  // namespace

void InstallCallbacks() {
  const std::lock_guard<std::mutex> lock(InstallMutex());
  const bool installed = host.mujoco.version != 0;
  if (!installed) {
    const MujocoSymbols found = FindMujoco();
    if (found.version == 0) throw InputError("there is no MuJoCo in this process");
    if (found.version != kMujocoVersion) {
      throw InputError("MuJoCo must be version " + std::to_string(kMujocoVersion) + ", got " +
                       std::to_string(found.version));
    }
    host.mujoco = found;
  }
  Install(host.mujoco.passive, &OnPassive, &host.earlier_passive, installed);
  InstallFreeNotice();
}

void LearnModels(OnError on_error) {
  host.on_error = on_error;
  host.learns_models = true;
}

void GiveSoil(const mjModel* m, mjData* d, std::shared_ptr<const SoilPlan> plan) {
  PutEntry(FingerprintOf(m, d), d, MakeSoil(std::move(plan)));
  ResetSoil(m, d);
}

void ResetSoil(const mjModel* m, mjData* d) {
  const std::shared_ptr<SoilEntry> entry = EntryOf(m, d);
  entry->soil->Reset(d);
  entry->lost_because.clear();
}

void TakeSoil(const mjModel* m, mjData* d) {
  const std::shared_ptr<SoilEntry> entry = EntryOf(m, d);
  PutEntry(entry->fingerprint, d, nullptr);
  entry->soil->Reset(d);
}

void RestoreSoil(mjData* d, const SoilState& state) {
  const std::shared_ptr<SoilEntry> entry = EntryOf(d);
  entry->soil->SetState(state, d);
  entry->lost_because.clear();
}

void CopySoil(const Fingerprint& of_src, const mjData* src, const SoilState& state, mjData* dst) {
  const std::shared_ptr<SoilEntry> entry = Registry::Get().Find(dst);
  if (entry != nullptr && entry->soil != nullptr && entry->fingerprint.buffer == dst->buffer) {
    RestoreSoil(dst, state);
    return;
  }
  if (dst->nbuffer != src->nbuffer) throw InputError("the mjData are of different models");
  PutEntry({of_src.model, dst->buffer, of_src.content}, dst, MakeSoil(state.plan));
  try {
    RestoreSoil(dst, state);
  } catch (...) {
    Registry::Get().Erase(dst);
    throw;
  }
}

}  // namespace softsoil
