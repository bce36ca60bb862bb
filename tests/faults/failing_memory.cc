#include "tests/faults/failing_memory.h"

#include <malloc.h>

#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <new>

namespace softsoil {
namespace {

thread_local bool is_this_thread = false;
std::atomic<bool> is_armed{false};
std::atomic<Whose> failing{Whose::kAnyThread};
std::atomic<long> calls{0}, first_failure{0}, last_failure{0};
std::atomic<long> allocated{0};  // [bytes]

bool Fails() {
  if (!is_armed) return false;
  if (failing == Whose::kThisThread && !is_this_thread) return false;
  if (failing == Whose::kOtherThreads && is_this_thread) return false;
  const long call = ++calls;
  return call >= first_failure && call <= last_failure;
}

void* Allocated(void* memory) {
  if (memory == nullptr) throw std::bad_alloc();
  allocated += static_cast<long>(malloc_usable_size(memory));
  return memory;
}

void Free(void* memory) {
  allocated -= static_cast<long>(malloc_usable_size(memory));
  std::free(memory);
}

}  // namespace

FailingMemory::FailingMemory(Whose whose, long first, long count) {
  is_this_thread = true;
  failing = whose;
  calls = 0;
  first_failure = first;
  last_failure = count == kAllFurther ? count : first + count - 1;
  is_armed = true;
}

FailingMemory::~FailingMemory() {
  is_armed = false;
  is_this_thread = false;
}

bool FailingMemory::HasFailed() const { return calls >= first_failure; }

long AllocatedBytes() { return allocated; }

}  // namespace softsoil

void* operator new(std::size_t size) {
  return softsoil::Allocated(softsoil::Fails() ? nullptr : std::malloc(size > 0 ? size : 1));
}

void* operator new(std::size_t size, std::align_val_t alignment) {
  const auto unit = static_cast<std::size_t>(alignment);
  const std::size_t whole = (size + unit - 1) / unit * unit;
  return softsoil::Allocated(softsoil::Fails() ? nullptr : std::aligned_alloc(unit, whole));
}

// What the library would do by itself, but a sanitizer has one that does not call ours.
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  try {
    return operator new(size);
  } catch (const std::bad_alloc&) {
    return nullptr;
  }
}

void operator delete(void* memory) noexcept { softsoil::Free(memory); }
void operator delete(void* memory, std::size_t) noexcept { softsoil::Free(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { softsoil::Free(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
  softsoil::Free(memory);
}
