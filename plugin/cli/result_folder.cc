#include "plugin/cli/result_folder.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>

#include "terrain/input_error.h"
#include "terrain/output_file.h"

namespace softsoil {
namespace {

// Descriptor that locks the folder until it is closed.
int Lock(const std::string& path) {
  const int folder = open(path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (folder >= 0 && flock(folder, LOCK_EX | LOCK_NB) == 0) return folder;
  const int reason = errno;
  if (folder >= 0) close(folder);
  if (reason == EWOULDBLOCK) {
    throw InputError(path + ": another softsoil is writing its results into this folder");
  }
  throw InputError(path + ": cannot lock this folder: " + std::strerror(reason));
}

void RequireReplaceable(const std::string& path, const std::vector<std::string>& inputs) {
  RequireNoInput(path, inputs);
  std::error_code error;
  if (std::filesystem::is_directory(path, error)) {
    throw InputError(path + ": is a folder, and a result would take its place");
  }
}

}  // namespace

ResultFolder::ResultFolder(const std::string& path, const std::vector<std::string>& names,
                           const std::vector<std::string>& inputs)
    : path_(path), names_(names) {
  PrepareFolder(path);
  lock_ = Lock(path);
  try {
    for (const std::string& name : names) RequireReplaceable(path + "/" + name, inputs);
  } catch (...) {
    close(lock_);
    throw;
  }
  std::error_code error;
  for (const std::string& name : names_) std::filesystem::remove(path_ + "/" + name, error);
}

void ResultFolder::Clear() const {
  std::error_code error;
  for (const std::string& name : names_) {
    for (const char* end : {"", ".part"}) std::filesystem::remove(path_ + "/" + name + end, error);
  }
}

ResultFolder::~ResultFolder() { close(lock_); }

}  // namespace softsoil
