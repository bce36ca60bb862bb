// Catalogue files made for a test, and the sentence with which one is refused.
#pragma once

#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "terrain/xml_catalogue.h"

namespace softsoil {

// A file of the running test's own; tests may run side by side.
inline std::string WriteFile(const std::string& name, const std::string& text) {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  const std::string path =
      testing::TempDir() + test->test_suite_name() + "_" + test->name() + "_" + name;
  std::ofstream(path, std::ios::binary) << text;
  return path;
}

// What `read` throws as InputError, after the place of `path`; empty if it throws nothing.
template <class Read>
std::string RefusalAt(const std::string& path, const Read& read) {
  try {
    read();
  } catch (const InputError& error) {
    const std::string sentence = error.what();
    EXPECT_EQ(sentence.substr(0, path.size()), path);
    return sentence.substr(path.size());
  }
  return "";
}

// The text with the first `from` replaced by `to`; `from` must be there.
inline std::string Replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

}  // namespace softsoil
