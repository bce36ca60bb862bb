// How much memory the process has been handed out, as the allocator tells.
#pragma once

#include <malloc.h>

namespace softsoil {

// [bytes]; 0 where another allocator than that of glibc is at work, as under sanitizers.
inline double HeapBytes() {
  const struct mallinfo2 heap = mallinfo2();
  return static_cast<double>(heap.uordblks) + static_cast<double>(heap.hblkhd);
}

}  // namespace softsoil
