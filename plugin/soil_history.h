// Past states of the soil of one mjData, by the marks under which copies of the mjData ask for
// them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <list>
#include <memory>
#include <mutex>
#include <unordered_map>

#include "plugin/soil_state.h"

namespace softsoil {

// Its owner adds to it in every step and takes no lock that another mjData takes, but for the
// moment in which one restores a state from this very history.
class SoilHistory {
 public:
  // bytes: what states besides the newest may take.
  explicit SoilHistory(std::size_t bytes);
  ~SoilHistory();
  SoilHistory(const SoilHistory&) = delete;
  SoilHistory& operator=(const SoilHistory&) = delete;

  // Keeps a state that takes so many `bytes` besides what it shares with the one before. Sets its
  // mark. Those that were asked for longest ago go where there is no more room.
  void Add(SoilState* state, std::size_t bytes);

  // The state that a mark names, in whatever history it is, alive for as long as the result is
  // held. Null if it is no longer held, or was never.
  static std::shared_ptr<const SoilState> Find(RevisionMark mark);

 private:
  struct Entry {
    double revision;
    std::size_t bytes;
    std::shared_ptr<const SoilState> state;
  };
  std::shared_ptr<const SoilState> FindHere(double revision);

  const double id_;
  const std::size_t bytes_allowed_;
  std::mutex mutex_;  // of what follows
  std::size_t bytes_ = 0;
  double last_revision_ = 0;
  std::list<Entry> entries_;  // the one asked for longest ago first
  std::unordered_map<double, std::list<Entry>::iterator> by_revision_;
};

// The state that a mark names, as Find(). Throws InputError if it is not held or is no mark.
std::shared_ptr<const SoilState> StateMarked(RevisionMark mark);

}  // namespace softsoil
