// wheels.csv: one row per wheel and output interval.
#pragma once

#include <string>
#include <vector>

#include "plugin/softsoil.h"
#include "terrain/output_file.h"

namespace softsoil {

class WheelLog {
 public:
  // Writes the names of the columns with their units.
  explicit WheelLog(const std::string& path);
  // time [s] of simulation.
  void Write(double time, const std::vector<softsoilWheel>& wheels);
  void Finish() { file_.Finish(); }

 private:
  OutputFile file_;
};

}  // namespace softsoil
