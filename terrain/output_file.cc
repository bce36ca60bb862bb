#include "terrain/output_file.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <stdexcept>

#include "terrain/input_error.h"

namespace softsoil {
namespace {

constexpr char kPart[] = ".part";

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
    : path_(path), part_(path + kPart), file_(std::fopen(part_.c_str(), "wb")) {
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
  const int closed = std::fclose(file_);
  file_ = nullptr;
  if (closed != 0) Fail("write");
  if (std::rename(part_.c_str(), path_.c_str()) != 0) Fail("rename");
}

void OutputFile::Discard() {
  if (file_ != nullptr) std::fclose(file_);
  file_ = nullptr;
  std::remove(part_.c_str());
}

void OutputFile::Fail(const char* action) const {
  throw std::runtime_error(part_ + ": cannot " + action + ": " + std::strerror(errno));
}

}  // namespace softsoil
