#pragma once

#include <algorithm>
#include <thread>

namespace softsoil {

// Number of processors, at least 1.
inline int Processors() {
  return static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
}

}  // namespace softsoil
