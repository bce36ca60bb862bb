// Runs the soil update in the background while the vehicle goes on.
//
// The exchange happens at fixed simulated times: a tick waits for the job of the tick before. So
// results do not depend on how fast a machine or a thread is.
#pragma once

#include <functional>
#include <future>

#include "terrain/state_stream.h"

namespace softsoil {

// Threads shared by all soils of the process, one per processor; made when first needed. They live
// to the very end of the process, for a host may step as long.
class WorkerPool {
 public:
  static WorkerPool& Shared();
  // Runs `job` on a worker; get() of the future rethrows what it threw.
  std::future<void> Run(std::function<void()> job);

 private:
  explicit WorkerPool(int threads);
  struct Impl;
  Impl* const impl_;  // the threads hold it, to the end
};

// The fixed instants of simulated time at which surface and soil exchange.
class SoilClock {
 public:
  // period [s] > 0.
  explicit SoilClock(double period) : period_(period) {}

  // Passes h [s] of simulated time; true from when a period is full to Restart(). Then Elapsed() is
  // its length, which differs from the nominal one if the time step does not divide it.
  bool Pass(double h) {
    elapsed_ += h;
    full_ = full_ || elapsed_ > period_ - h / 2;
    return full_;
  }
  double Elapsed() const { return elapsed_; }
  void Restart() { *this = SoilClock(period_); }

  void Write(StateWriter& writer) const {
    writer.Put(elapsed_);
    writer.Put(full_);
  }
  void Read(StateReader& reader) {
    elapsed_ = reader.GetFinite();
    full_ = reader.GetFlag();
  }

 private:
  double period_;
  double elapsed_ = 0;
  bool full_ = false;
};

}  // namespace softsoil
