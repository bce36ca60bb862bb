#include "plugin/cli/controls.h"

#include <algorithm>

#include "terrain/csv_lines.h"
#include "terrain/input_error.h"

namespace softsoil {
namespace {

constexpr char kTime[] = "time";

std::string Names(const std::vector<Actuator>& actuators) {
  std::string names;
  for (const Actuator& a : actuators) names += (names.empty() ? "" : ", ") + a.name;
  return names.empty() ? "none" : names;
}

// Numbers of the actuators by column.
std::vector<int> ReadHeader(const CsvLines& lines, const std::vector<std::string>& cells,
                            const std::vector<Actuator>& actuators) {
  if (cells[0] != kTime) lines.Refuse("the first column must be time, got \"" + cells[0] + "\"");
  if (cells.size() == 1) lines.Refuse("a column for an actuator must follow time");
  std::vector<int> columns;
  for (std::size_t c = 1; c < cells.size(); ++c) {
    const auto it = std::find_if(actuators.begin(), actuators.end(),
                                 [&](const Actuator& a) { return a.name == cells[c]; });
    if (std::count(cells.begin(), cells.begin() + c, cells[c]) != 0) {
      lines.Refuse("column \"" + cells[c] + "\" stands here a second time");
    }
    if (it == actuators.end() || cells[c].empty()) {
      lines.Refuse("unknown column \"" + cells[c] +
                   "\"; the actuators of the model are: " + Names(actuators));
    }
    columns.push_back(static_cast<int>(it - actuators.begin()));
  }
  return columns;
}

double ReadControl(const CsvLines& lines, const Actuator& actuator, const std::string& cell) {
  const double value = lines.Number(actuator.name, cell);
  if (value < actuator.low || value > actuator.high) {
    lines.Refuse(actuator.name + " must be " + Shown(actuator.low) + " to " + Shown(actuator.high) +
                 ", got " + cell);
  }
  return value;
}

}  // namespace

Controls::Controls(const std::string& file, const std::vector<Actuator>& actuators) {
  CsvLines lines(file);
  std::vector<std::string> cells;
  if (!lines.Next(&cells)) lines.Refuse("the line with the names of the columns is missing");
  actuators_ = ReadHeader(lines, cells, actuators);
  const std::size_t width = cells.size();

  while (lines.Next(&cells)) {
    lines.RequireWidth(cells, width);
    const double time = lines.Number(kTime, cells[0]);
    if (!times_.empty() && time <= times_.back()) {
      lines.Refuse("time must be greater than in the row before, " + Shown(times_.back()) +
                   " s, got " + cells[0]);
    }
    times_.push_back(time);
    std::vector<double> row;
    for (std::size_t c = 1; c < width; ++c) {
      row.push_back(ReadControl(lines, actuators[actuators_[c - 1]], cells[c]));
    }
    values_.push_back(std::move(row));
  }
  if (times_.empty()) lines.Refuse("a row of numbers must follow the names of the columns");
}

void Controls::Apply(double time, double* controls) const {
  if (times_.empty()) return;
  const auto after = std::upper_bound(times_.begin(), times_.end(), time);
  const std::size_t right = std::min<std::size_t>(after - times_.begin(), times_.size() - 1);
  const std::size_t left = after == times_.begin() || after == times_.end() ? right : right - 1;
  const double span = times_[right] - times_[left];
  const double part = span > 0 ? (time - times_[left]) / span : 0.0;
  for (std::size_t c = 0; c < actuators_.size(); ++c) {
    controls[actuators_[c]] = values_[left][c] + part * (values_[right][c] - values_[left][c]);
  }
}

}  // namespace softsoil
