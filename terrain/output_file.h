// Files that are either complete or not there.
#pragma once

#include <cstdio>
#include <string>
#include <vector>

namespace softsoil {

// Makes the folder if it is not there. Throws InputError if files cannot be written in it.
void PrepareFolder(const std::string& folder);

// Throws InputError if a file that is to be written is one of the inputs, however it is spelled; or
// <path>.part, see below.
void RequireNoInput(const std::string& path, const std::vector<std::string>& inputs);

// Written as <path>.part, and renamed to <path> when complete: a run that is killed leaves no half
// result. Every write is checked; a full disk throws std::runtime_error, and so does a file that
// someone else is writing.
class OutputFile {
 public:
  explicit OutputFile(const std::string& path);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  void Write(const void* bytes, std::size_t size);
  void Write(const std::string& text) { Write(text.data(), text.size()); }
  void Flush();
  // No call may follow.
  void Finish();
  // Removes what was written so far. No call may follow.
  void Discard();

  const std::string& path() const { return path_; }

 private:
  [[noreturn]] void Fail(const char* action) const;

  std::string path_, part_;
  std::FILE* file_;
};

}  // namespace softsoil
