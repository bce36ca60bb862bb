#include "plugin/cli/wheel_log.h"

#include <cstdio>

#include "plugin/cli/wheel_columns.h"

namespace softsoil {
namespace {

std::string Cell(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.9g", value);
  return text;
}

// A name from a model may hold anything.
std::string Cell(const std::string& name) {
  if (name.find_first_of(",\"\n\r") == std::string::npos) return name;
  std::string quoted = "\"";
  for (const char c : name) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + '"';
}

}  // namespace

WheelLog::WheelLog(const std::string& path) : file_(path) {
  std::string header = "time [s],wheel";
  for (const WheelColumn& c : WheelColumns()) {
    header += std::string(",") + c.name + " [" + c.unit + "]";
  }
  file_.Write(header + "\n");
}

void WheelLog::Write(double time, const std::vector<softsoilWheel>& wheels) {
  for (const softsoilWheel& wheel : wheels) {
    std::string row = Cell(time) + "," + Cell(std::string(wheel.name));
    for (const WheelColumn& c : WheelColumns()) row += "," + Cell(c.value(wheel) * c.from_si);
    file_.Write(row + "\n");
  }
  file_.Flush();
}

}  // namespace softsoil
