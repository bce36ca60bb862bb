#include "plugin/cli/controls.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "terrain/input_error.h"

namespace softsoil {
namespace {

constexpr char kTime[] = "time";

std::string Trimmed(const std::string& text) {
  const char* blank = " \t\r";
  const std::size_t first = text.find_first_not_of(blank);
  if (first == std::string::npos) return "";
  return text.substr(first, text.find_last_not_of(blank) - first + 1);
}

std::vector<std::string> Cells(const std::string& line) {
  std::vector<std::string> cells;
  std::size_t start = 0;
  for (std::size_t comma = 0; comma != std::string::npos; start = comma + 1) {
    comma = line.find(',', start);
    cells.push_back(Trimmed(line.substr(start, comma - start)));
  }
  return cells;
}

// The lines of a CSV file that say something, and where they stand.
class Lines {
 public:
  explicit Lines(const std::string& file) : file_(file), stream_(file) {
    if (std::filesystem::is_directory(file)) throw InputError(file + ": is a folder, not a file");
    if (!stream_) throw InputError(file + ": cannot read: " + std::strerror(errno));
  }

  // The cells of the next line; false at the end.
  bool Next(std::vector<std::string>* cells) {
    std::string line;
    while (std::getline(stream_, line)) {
      ++number_;
      constexpr char kByteOrderMark[] = "\xEF\xBB\xBF";  // spreadsheets write it
      if (number_ == 1 && line.compare(0, 3, kByteOrderMark) == 0) line.erase(0, 3);
      line = Trimmed(line);
      if (line.empty() || line[0] == '#') continue;
      *cells = Cells(line);
      return true;
    }
    return false;
  }

  [[noreturn]] void Refuse(const std::string& rule) const {
    throw InputError(file_ + ":" + std::to_string(std::max(number_, 1)) + ": " + rule);
  }

 private:
  std::string file_;
  std::ifstream stream_;
  int number_ = 0;
};

std::string Names(const std::vector<Actuator>& actuators) {
  std::string names;
  for (const Actuator& a : actuators) names += (names.empty() ? "" : ", ") + a.name;
  return names.empty() ? "none" : names;
}

// Numbers of the actuators by column.
std::vector<int> ReadHeader(const Lines& lines, const std::vector<std::string>& cells,
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

double ReadNumber(const Lines& lines, const std::string& name, const std::string& cell) {
  if (cell.empty()) lines.Refuse(name + " is missing");
  double value = 0;
  if (!ParseNumber(cell, &value)) {
    lines.Refuse(name + " must be a finite number, got \"" + cell + "\"");
  }
  return value;
}

double ReadControl(const Lines& lines, const Actuator& actuator, const std::string& cell) {
  const double value = ReadNumber(lines, actuator.name, cell);
  if (value < actuator.low || value > actuator.high) {
    lines.Refuse(actuator.name + " must be " + Shown(actuator.low) + " to " + Shown(actuator.high) +
                 ", got " + cell);
  }
  return value;
}

}  // namespace

Controls::Controls(const std::string& file, const std::vector<Actuator>& actuators) {
  Lines lines(file);
  std::vector<std::string> cells;
  if (!lines.Next(&cells)) lines.Refuse("the line with the names of the columns is missing");
  actuators_ = ReadHeader(lines, cells, actuators);
  const std::size_t width = cells.size();

  while (lines.Next(&cells)) {
    if (cells.size() != width) {
      lines.Refuse("there must be " + std::to_string(width) + " cells as in the header, got " +
                   std::to_string(cells.size()));
    }
    const double time = ReadNumber(lines, kTime, cells[0]);
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
