#include "terrain/output_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <stdexcept>

#include "terrain/input_error.h"

namespace softsoil {
namespace {

constexpr char kPart[] = ".part";

// Whether the name still stands for the open file: who held it before may have renamed it.
bool IsStill(int file, const std::string& path) {
  struct stat open, named;
  return fstat(file, &open) == 0 && stat(path.c_str(), &named) == 0 &&
         open.st_dev == named.st_dev && open.st_ino == named.st_ino;
}

// Empties a file that is open, unless someone else writes it. Else errno tells why.
bool IsAlone(int file, const std::string& path) {
  struct stat status;
  if (fstat(file, &status) != 0) return false;
  if (!S_ISREG(status.st_mode)) return true;
  const bool is_taken = flock(file, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  if (!is_taken && IsStill(file, path)) return ftruncate(file, 0) == 0;
  errno = EBUSY;
  return false;
}

// Null and errno if that fails. A pipe to which no one listens is refused: to open it would take
// for ever.
std::FILE* OpenAlone(const std::string& path) {
  const int file = open(path.c_str(), O_WRONLY | O_CREAT | O_NONBLOCK | O_CLOEXEC, 0666);
  if (file < 0) return nullptr;
  fcntl(file, F_SETFL, fcntl(file, F_GETFL) & ~O_NONBLOCK);  // writing may wait
  std::FILE* const stream = IsAlone(file, path) ? fdopen(file, "wb") : nullptr;
  if (stream != nullptr) return stream;
  const int reason = errno;
  close(file);
  errno = reason;
  return nullptr;
}

}  // namespace

void PrepareFolder(const std::string& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (!error && !std::filesystem::is_directory(folder, error)) {
    error = std::make_error_code(std::errc::not_a_directory);
  }
  if (!error && access(folder.c_str(), W_OK | X_OK) != 0) {
    error = std::error_code(errno, std::generic_category());
  }
  if (error) throw InputError(folder + ": cannot write into this folder: " + error.message());
}

void RequireNoInput(const std::string& path, const std::vector<std::string>& inputs) {
  std::error_code error;  // a file that is not there is none of them
  for (const std::string& written : {path, path + kPart}) {
    for (const std::string& input : inputs) {
      if (!std::filesystem::equivalent(written, input, error)) continue;
      throw InputError(written + ": is an input, and a result would take its place");
    }
  }
}

OutputFile::OutputFile(const std::string& path)
    : path_(path), part_(path + kPart), file_(OpenAlone(part_)) {
  if (file_ == nullptr) Fail("open");
}

OutputFile::~OutputFile() {
  if (file_ != nullptr) std::fclose(file_);
}

void OutputFile::Write(const void* bytes, std::size_t size) {
  if (size > 0 && std::fwrite(bytes, 1, size, file_) != size) Fail("write");
}

void OutputFile::Flush() {
  if (std::fflush(file_) != 0) Fail("write");
}

void OutputFile::Finish() {
  Flush();
  const int lock = dup(fileno(file_));  // until the file has its name
  const int closed = std::fclose(file_);
  file_ = nullptr;
  const bool is_renamed = closed == 0 && std::rename(part_.c_str(), path_.c_str()) == 0;
  const int reason = errno;
  if (lock >= 0) close(lock);
  errno = reason;
  if (!is_renamed) Fail(closed == 0 ? "rename" : "write");
}

void OutputFile::Discard() {
  std::remove(part_.c_str());
  if (file_ != nullptr) std::fclose(file_);
  file_ = nullptr;
}

void OutputFile::Fail(const char* action) const {
  throw std::runtime_error(part_ + ": cannot " + action + ": " + std::strerror(errno));
}

}  // namespace softsoil
