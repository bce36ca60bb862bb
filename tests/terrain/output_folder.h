// Files that a test writes.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace softsoil {

inline std::string Content(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

// An empty folder for each test: they run in parallel.
class OutputFolder : public testing::Test {
 protected:
  OutputFolder() { std::filesystem::create_directories(folder_); }
  ~OutputFolder() override { std::filesystem::remove_all(folder_); }
  const std::string folder_ = testing::TempDir() + "output_" + std::to_string(getpid());
  const std::string path_ = folder_ + "/a.txt";
};

}  // namespace softsoil
