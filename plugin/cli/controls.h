// Controls of actuators over time, read from a CSV file: a column `time` [s], and one for each
// actuator that is to be driven, under its name in the model. Lines that start with # are comments.
#pragma once

#include <string>
#include <vector>

namespace softsoil {

// What a control may be. `low` and `high` are infinite where the model sets no limit.
struct Actuator {
  std::string name;
  double low, high;
};

class Controls {
 public:
  // None: leaves every control as it is.
  Controls() = default;
  // Throws InputError with file, line, rule and value.
  Controls(const std::string& file, const std::vector<Actuator>& actuators);

  // Writes the controls at `time` [s] of the actuators that the file drives: linear between rows,
  // and held before the first and after the last.
  void Apply(double time, double* controls) const;

 private:
  std::vector<int> actuators_;               // by column, without time
  std::vector<double> times_;                // [s]  by row, rising
  std::vector<std::vector<double>> values_;  // by row and column
};

}  // namespace softsoil
