// The README's table of settings is the table that the code reads.
#include <gtest/gtest.h>

#include <fstream>
#include <string>
#include <vector>

#include "plugin/settings.h"

namespace softsoil {
namespace {

std::string ElementOf(SettingKind kind) {
  switch (kind) {
    case SettingKind::kText: return "text";
    case SettingKind::kBodies: return "tuple";
    case SettingKind::kNumber:
    case SettingKind::kWholeNumber: return "numeric";
  }
  return "";
}

std::vector<std::string> RowsInCode() {
  std::vector<std::string> rows;
  for (const Setting& s : SettingTable()) {
    rows.push_back("| `" + std::string(s.name) + "` | " + ElementOf(s.kind) + " | " + s.unit +
                   " | " + s.fallback + " | " + s.meaning + " |");
  }
  return rows;
}

// The rows below the head of the table that has a column "key".
std::vector<std::string> RowsInReadme() {
  std::ifstream readme(SOFTSOIL_SOURCE_DIR "/README.md");
  std::vector<std::string> rows;
  bool inside = false;
  for (std::string line; std::getline(readme, line);) {
    if (inside && line.rfind("| `", 0) == 0) rows.push_back(line);
    if (line.rfind("| key |", 0) == 0) inside = true;
    if (line.empty()) inside = false;
  }
  return rows;
}

TEST(Readme, ListsTheSettingsAsTheCodeReadsThem) {
  ASSERT_FALSE(RowsInReadme().empty());
  EXPECT_EQ(RowsInReadme(), RowsInCode());
}

}  // namespace
}  // namespace softsoil
