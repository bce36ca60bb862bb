#include "plugin/models_folder.h"

#include <dlfcn.h>

#include <filesystem>

namespace softsoil {
namespace {

namespace fs = std::filesystem;

std::string FindLibraryFile() {
  Dl_info info;
  static const char here = 0;
  std::error_code failed;
  if (dladdr(&here, &info) != 0 && info.dli_fname != nullptr) {
    const fs::path file = fs::canonical(info.dli_fname, failed);
    if (!failed) return file;
  }
  // Of the program itself dladdr() gives what the shell called it.
  return fs::read_symlink("/proc/self/exe", failed);
}

}  // namespace

const std::string& LibraryFile() {
  static const auto* const file = new std::string(FindLibraryFile());
  return *file;
}

std::string ModelsFolder() {
  return (fs::path(LibraryFile()).parent_path().parent_path() / "share/softsoil/models").string();
}

}  // namespace softsoil
