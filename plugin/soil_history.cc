#include "plugin/soil_history.h"

#include <map>
#include <random>
#include <utility>

#include "terrain/input_error.h"

namespace softsoil {
namespace {

// Any whole number from 2^52 to 2^53, below which doubles are exact. By chance: a mark that
// outlives its process names no history of another.
double NewId() {
  static std::random_device random;
  const std::uint64_t bits = (std::uint64_t{random()} << 32) | random();
  return kLeastHistory + static_cast<double>(bits >> 12);
}

// All histories of the process. Asked only when a mjData is made, freed or restored.
class Histories {
 public:
  static Histories& Get() {
    static auto* const histories = new Histories;  // a host may step until the very end
    return *histories;
  }
  double Enter(SoilHistory* history) {
    const std::lock_guard<std::mutex> lock(mutex_);
    double id = NewId();
    while (!by_id_.emplace(id, history).second) id = NewId();
    return id;
  }
  void Leave(double id) {
    const std::lock_guard<std::mutex> lock(mutex_);
    by_id_.erase(id);
  }
  // ask(SoilHistory&), which cannot die meanwhile; not called if there is none.
  template <class Asker>
  void Ask(double id, const Asker& ask) {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto it = by_id_.find(id);
    if (it != by_id_.end()) ask(*it->second);
  }

 private:
  std::mutex mutex_;
  std::map<double, SoilHistory*> by_id_;
};

}  // namespace

SoilHistory::SoilHistory(std::size_t bytes)
    : id_(Histories::Get().Enter(this)), bytes_allowed_(bytes) {}

SoilHistory::~SoilHistory() { Histories::Get().Leave(id_); }

void SoilHistory::Add(SoilState* state, std::size_t bytes) {
  std::list<Entry> added, dropped;  // die after the lock is released
  const std::lock_guard<std::mutex> lock(mutex_);
  const double revision = last_revision_ + 1;
  state->mark = {id_, revision};
  // All that may fail comes first.
  added.push_back({revision, bytes, std::make_shared<SoilState>(*state)});
  by_revision_.emplace(revision, added.begin());

  entries_.splice(entries_.end(), added);
  last_revision_ = revision;
  bytes_ += bytes;
  while (bytes_ > bytes_allowed_ && entries_.size() > 1) {
    bytes_ -= entries_.front().bytes;
    by_revision_.erase(entries_.front().revision);
    dropped.splice(dropped.end(), entries_, entries_.begin());
  }
}

std::shared_ptr<const SoilState> SoilHistory::Find(RevisionMark mark) {
  std::shared_ptr<const SoilState> state;
  Histories::Get().Ask(mark.history,
                       [&](SoilHistory& history) { state = history.FindHere(mark.revision); });
  return state;
}

std::shared_ptr<const SoilState> SoilHistory::FindHere(double revision) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto it = by_revision_.find(revision);
  if (it == by_revision_.end()) return nullptr;
  entries_.splice(entries_.end(), entries_, it->second);
  return it->second->state;
}

std::shared_ptr<const SoilState> StateMarked(RevisionMark mark) {
  if (!mark.IsPossible()) {
    throw InputError("the last " + std::to_string(kMarkSize) + " numbers of userdata hold " +
                     Shown(mark.history) + " and " + Shown(mark.revision) +
                     ", no mark of a soil state: they belong to softsoil; make <size nuserdata> "
                     "larger by them, or set softsoil_history to 0");
  }
  std::shared_ptr<const SoilState> state = SoilHistory::Find(mark);
  if (state != nullptr) return state;
  throw InputError(
      "this mjData was copied or restored to the soil state " + Shown(mark.revision) +
      " of a mjData, which is no longer held: that mjData is gone, or softsoil_history "
      "is too small for so long ago");
}

}  // namespace softsoil
