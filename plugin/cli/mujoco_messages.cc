#include "plugin/cli/mujoco_messages.h"

#include <mujoco/mujoco.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <mutex>

#include "plugin/cli/exit_code.h"

namespace softsoil {
namespace {

// MuJoCo's handlers are global and take no user data, and its threads may call them.
std::mutex mutex;
std::vector<std::string> warnings;

// No exception here: it would have to pass through MuJoCo, which is written in C. Files in work
// keep their temporary name.
void EndProgram(const char* message) {
  std::fprintf(stderr, "softsoil: MuJoCo: %s\n", message);
  std::_Exit(kFailed);
}

void Remember(const char* message) {
  const std::lock_guard<std::mutex> lock(mutex);
  if (std::count(warnings.begin(), warnings.end(), message) != 0) return;
  warnings.push_back(message);
  std::fprintf(stderr, "softsoil: MuJoCo warns: %s\n", message);
}

}  // namespace

void HandleMujocoMessages() {
  mju_user_error = EndProgram;
  mju_user_warning = Remember;
}

std::vector<std::string> MujocoWarnings() {
  const std::lock_guard<std::mutex> lock(mutex);
  return warnings;
}

}  // namespace softsoil
