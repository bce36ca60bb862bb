// How many threads parallel loops may add to those that run them.
//
// Loops of several soils run at once. Each takes from one budget what is free at that moment, so
// that all of them together keep a bounded number of threads busy. Results must not depend on it.
#pragma once

#include <algorithm>
#include <atomic>

#include "terrain/processors.h"

namespace softsoil {

// For all threads, without a lock.
class ThreadBudget {
 public:
  // Some threads of a budget, given back at the end of the scope.
  class Share {
   public:
    Share(ThreadBudget* budget, int threads) : budget_(budget), threads_(threads) {}
    ~Share() { budget_->free_ += threads_; }
    Share(const Share&) = delete;
    Share& operator=(const Share&) = delete;

    int threads() const { return threads_; }

   private:
    ThreadBudget* budget_;
    int threads_;
  };

  explicit ThreadBudget(int threads) : free_(threads) {}

  // Of the process: one thread per processor.
  static ThreadBudget& Shared() {
    static ThreadBudget budget(Processors());
    return budget;
  }

  // At most `wanted` threads, none if none is free.
  Share Take(int wanted) {
    int free = free_;
    int taken = 0;
    do {
      taken = std::clamp(wanted, 0, free);
    } while (!free_.compare_exchange_weak(free, free - taken));
    return {this, taken};
  }

 private:
  std::atomic<int> free_;
};

}  // namespace softsoil
