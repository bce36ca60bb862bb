// LD_PRELOAD=libsoftsoil.so PROGRAM: soft soil in a program that knows nothing of it.
//
// The preload reaches every process that the program starts, shells too: where there is no MuJoCo,
// nothing happens and nothing is said. A program that links the library chooses by itself which
// mjData get soil, so there nothing happens either.
#include <dlfcn.h>

#include <cstdlib>
#include <cstring>
#include <exception>
#include <filesystem>

#include "plugin/host.h"
#include "plugin/log.h"
#include "plugin/models_folder.h"
#include "plugin/mujoco_symbols.h"
#include "plugin/softsoil.h"
#include "plugin/words.h"
#include "terrain/input_error.h"

namespace softsoil {
namespace {

// Whether LD_PRELOAD names the file of this library, and this copy of it is the one that the
// process uses: a second copy, linked by the program, must not act besides.
bool IsPreloaded() {
  const char* preload = std::getenv("LD_PRELOAD");
  if (preload == nullptr) return false;
  if (dlsym(RTLD_DEFAULT, "softsoil_attach") != reinterpret_cast<void*>(&softsoil_attach)) {
    return false;
  }
  const auto our_name = std::filesystem::path(LibraryFile()).filename();
  for (const std::string& entry : Words(preload, ": ")) {
    std::error_code failed;
    const std::filesystem::path file = std::filesystem::canonical(entry, failed);
    if ((failed ? std::filesystem::path(entry) : file).filename() == our_name) return true;
  }
  return false;
}

// SOFTSOIL_ON_ERROR=stop|continue.
OnError ErrorPolicy() {
  const char* policy = std::getenv("SOFTSOIL_ON_ERROR");
  if (policy == nullptr || std::strcmp(policy, "stop") == 0) return OnError::kStop;
  if (std::strcmp(policy, "continue") == 0) return OnError::kContinue;
  throw InputError("SOFTSOIL_ON_ERROR: must be stop or continue, got \"" + std::string(policy) +
                   "\"");
}

void EnterHost() {
  if (!IsPreloaded() || FindMujoco().version == 0) return;
  const OnError on_error = ErrorPolicy();
  InstallCallbacks();
  LearnModels(on_error);
}

// All libraries are mapped and relocated before the first constructor runs, so MuJoCo's variables
// can be set.
__attribute__((constructor)) void OnLoad() {
  try {
    LibraryFile();  // while relative paths still hold
    EnterHost();
  } catch (const std::exception& error) {
    Say(std::string(error.what()) + "; soft soil is off");
  }
}

}  // namespace
}  // namespace softsoil
