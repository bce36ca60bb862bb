// A parameter that measurements determine, and how well.
#pragma once

#include <map>
#include <vector>

#include "terrain/least_squares.h"

namespace softsoil {

struct Fitted {
  double value;
  double standard_error;
  double confidence;  // half width of the 95 % interval (Student's t)
};

// Parameter `i` of a fit that was made in units of `scale`.
inline Fitted FittedParameter(const Fit& fit, int i, double scale) {
  return {fit.parameters[i] * scale, fit.standard_error[i] * scale, fit.confidence[i] * scale};
}

// A parameter that a bound decides, not the data.
inline Fitted HeldAt(double value) { return {value, 0, 0}; }

// Rows of each value of a column, both in order: the tests of one plate or one normal stress.
inline std::map<double, std::vector<std::size_t>> RowsByValue(const std::vector<double>& column) {
  std::map<double, std::vector<std::size_t>> rows;
  for (std::size_t row = 0; row < column.size(); ++row) rows[column[row]].push_back(row);
  return rows;
}

}  // namespace softsoil
