// Memory that runs out when a test says so: this program has an operator new of its own.
#pragma once

#include <limits>

namespace softsoil {

enum class Whose { kThisThread, kOtherThreads, kAnyThread };

constexpr long kAllFurther = std::numeric_limits<long>::max();

// While it lives, operator new of these threads fails `count` times from its `first` call on,
// counted from 1. One at a time.
class FailingMemory {
 public:
  FailingMemory(Whose whose, long first, long count = kAllFurther);
  ~FailingMemory();
  FailingMemory(const FailingMemory&) = delete;
  FailingMemory& operator=(const FailingMemory&) = delete;

  bool HasFailed() const;
};

// Bytes that operator new has given to this program and that are in use.
long AllocatedBytes();

}  // namespace softsoil
