// Finds the MuJoCo that runs in this process. The library never links libmujoco: preloaded into a
// program without MuJoCo it must do nothing.
#pragma once

#include <mujoco/mujoco.h>

namespace softsoil {

constexpr int kMujocoVersion = 222;  // the only one whose mjModel and mjData this library knows

// Addresses of MuJoCo's global variables.
struct MujocoSymbols {
  int version = 0;  // 0: no MuJoCo in this process
  mjfGeneric* passive = nullptr;
  mjfConFilt* contact_filter = nullptr;
  void (**user_error)(const char*) = nullptr;
  void* (**user_malloc)(size_t) = nullptr;
  void (**user_free)(void*) = nullptr;
};

// Looks among the symbols visible to all, then in a libmujoco that was loaded for its caller
// alone, as Python does.
MujocoSymbols FindMujoco();

}  // namespace softsoil
