#include "plugin/cli/csv_cell.h"

#include <cstdio>

namespace softsoil {

std::string CsvCell(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.9g", value);
  return text;
}

std::string CsvCell(const std::optional<double>& value) { return value ? CsvCell(*value) : ""; }

std::string CsvCell(const std::string& name) {
  if (name.find_first_of(",\"\n\r") == std::string::npos) return name;
  std::string quoted = "\"";
  for (const char c : name) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + '"';
}

}  // namespace softsoil
