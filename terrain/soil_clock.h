// The fixed instants of simulated time at which surface and soil exchange: a tick waits for the
// update of the tick before. So results do not depend on how fast a machine or a thread is.
#pragma once

#include "terrain/state_stream.h"

namespace softsoil {

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
  void Read(StateReader& reader) {  // throws InputError
    elapsed_ = reader.GetFinite();
    full_ = reader.GetFlag();
    reader.Require(full_ ? IsFullAt(elapsed_) : elapsed_ >= 0 && elapsed_ <= period_,
                   "the time of the soil clock");
  }
  // Whether a period may have this length [s]: the last step is within it.
  bool IsFullAt(double elapsed) const { return elapsed > period_ / 2; }

 private:
  double period_;
  double elapsed_ = 0;
  bool full_ = false;
};

}  // namespace softsoil
