// One table says what is reported of a wheel: wheels.csv, summary.json and the averages use it.
#pragma once

#include <string>
#include <vector>

#include "plugin/softsoil.h"

namespace softsoil {

struct WheelColumn {
  const char* name;
  const char* unit;  // in the files
  double from_si;    // factor from SI to that unit
  bool averaged;     // the summary holds the mean, else the last value
  double (*value)(const softsoilWheel&);
};
const std::vector<WheelColumn>& WheelColumns();

// The name in summary.json, which says so where the unit is degrees.
std::string KeyOf(const WheelColumn& column);

// Values of the columns, averaged over time.
class WheelMean {
 public:
  void Add(const softsoilWheel& wheel);
  // By column; zeros before the first Add().
  std::vector<double> Values() const;
  // Of the column with that key.
  double Value(const std::string& key) const;

 private:
  std::vector<double> sums_, last_;
  int count_ = 0;
};

}  // namespace softsoil
