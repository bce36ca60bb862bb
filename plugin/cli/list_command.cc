// softsoil list: the names that a model or a command may use.
#include <algorithm>
#include <cstdio>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "contact/tire_family.h"
#include "plugin/cli/catalogues.h"
#include "plugin/cli/commands.h"
#include "plugin/cli/paths.h"
#include "plugin/cli/standard_output.h"

namespace softsoil {
namespace {

using Rows = std::vector<std::pair<std::string, std::string>>;  // name, description

template <class Entries>
Rows RowsOf(const Entries& entries) {
  Rows rows;
  for (const auto& entry : entries) rows.emplace_back(entry.name, entry.description);
  return rows;
}

// The entries, and the families that any pressure can be chosen of.
Rows Tires() {
  const Catalogue<Tire> catalogue = TiresWith();
  Rows rows = RowsOf(catalogue.entries());
  for (const TireFamily& family : TireFamilies(catalogue)) {
    if (family.lowest == family.highest) continue;
    rows.emplace_back(family.name + kAtPressure + "PRESSURE",
                      "Any inflation pressure from " + TestedPressures(family));
  }
  return rows;
}

Rows RowsOfKind(const std::string& kind) {
  if (kind == "soils") return RowsOf(SoilsWith().entries());
  if (kind == "tires") return Tires();
  return RowsOf(ShippedScenes());
}

void Print(const std::string& kind) {
  const Rows rows = RowsOfKind(kind);
  std::size_t width = 0;
  for (const auto& row : rows) width = std::max(width, row.first.size());
  std::printf("%s\n", kind.c_str());
  for (const auto& [name, description] : rows) {
    std::printf("  %-*s  %s\n", static_cast<int>(width), name.c_str(), description.c_str());
  }
}

}  // namespace

void AddListCommand(CLI::App& program) {
  static const std::vector<std::string> kinds = {"soils", "tires", "scenes"};
  CLI::App* command = program.add_subcommand("list", "Show the soils, tires and scenes");
  auto kind = std::make_shared<std::string>();
  command->add_option("kind", *kind, "soils, tires or scenes; all three if left out")
      ->check(CLI::IsMember(kinds));
  command->callback([kind] {
    for (const std::string& known : kinds) {
      if (kind->empty() || *kind == known) Print(known);
    }
    FlushStandardOutput();
  });
}

}  // namespace softsoil
