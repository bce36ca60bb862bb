#include "plugin/cli/wheel_log.h"

#include "plugin/cli/csv_cell.h"
#include "plugin/cli/wheel_columns.h"

namespace softsoil {

WheelLog::WheelLog(const std::string& path) : file_(path) {
  std::string header = "time [s],wheel";
  for (const WheelColumn& c : WheelColumns()) {
    header += std::string(",") + c.name + " [" + c.unit + "]";
  }
  file_.Write(header + "\n");
}

void WheelLog::Write(double time, const std::vector<softsoilWheel>& wheels) {
  for (const softsoilWheel& wheel : wheels) {
    std::string row = CsvCell(time) + "," + CsvCell(std::string(wheel.name));
    for (const WheelColumn& c : WheelColumns()) row += "," + CsvCell(c.value(wheel) * c.from_si);
    file_.Write(row + "\n");
  }
  file_.Flush();
}

}  // namespace softsoil
