// Where the wall time of soft ground goes.
#pragma once

#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>

namespace softsoil {

enum class Work { kContact, kFlow, kWaiting, kStress, kCompaction };

// Sums since the start; any thread may add. They tell of the machine and are no part of a state:
// copies of a ground share them.
class WallTimes {
 public:
  void Add(Work work, std::chrono::nanoseconds time) { sums_[Index(work)] += time.count(); }
  double Of(Work work) const { return 1e-9 * sums_[Index(work)]; }  // [s]

 private:
  static int Index(Work work) { return static_cast<int>(work); }
  std::array<std::atomic<std::int64_t>, 5> sums_ = {};  // [ns]
};

// Adds the time of the block that it stands in; to nobody if `times` is null.
class Stopwatch {
 public:
  Stopwatch(WallTimes* times, Work work) : times_(times), work_(work) {}
  ~Stopwatch() {
    if (times_ != nullptr) times_->Add(work_, std::chrono::steady_clock::now() - begun_);
  }
  Stopwatch(const Stopwatch&) = delete;
  Stopwatch& operator=(const Stopwatch&) = delete;

 private:
  WallTimes* times_;
  Work work_;
  std::chrono::steady_clock::time_point begun_ = std::chrono::steady_clock::now();
};

}  // namespace softsoil
