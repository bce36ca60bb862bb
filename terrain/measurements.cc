#include "terrain/measurements.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "terrain/csv_lines.h"
#include "terrain/input_error.h"

namespace softsoil {
namespace {

// Inch, pound-force and psi: NIST SP 811 (2008), appendix B.8.
constexpr Unit kUnits[] = {
    {"m", Quantity::kLength, 1, 0},
    {"cm", Quantity::kLength, 1, -2},
    {"mm", Quantity::kLength, 1, -3},
    {"in", Quantity::kLength, 254, -4},
    {"N", Quantity::kForce, 1, 0},
    {"kN", Quantity::kForce, 1, 3},
    {"lbf", Quantity::kForce, 4.4482216152605, 0},
    {"Pa", Quantity::kPressure, 1, 0},
    {"kPa", Quantity::kPressure, 1, 3},
    {"bar", Quantity::kPressure, 1, 5},
    {"psi", Quantity::kPressure, 6894.757293168, 0},
};

// value * 10^places, by the exponent of its decimal digits.
double WithPointMoved(double value, int places) {
  if (!std::isfinite(value)) return value;
  char text[32];
  const std::string written(
      text, std::to_chars(text, text + sizeof text, value, std::chars_format::scientific).ptr);
  const std::size_t e = written.find('e');
  const int exponent = std::stoi(written.substr(e + 1)) + places;
  double moved = value * std::pow(10.0, places);  // stays if no double has these digits
  ParseNumber(written.substr(0, e + 1) + std::to_string(exponent), &moved);
  return moved;
}

std::string SiUnitOf(Quantity quantity) {
  const auto* unit = std::find_if(std::begin(kUnits), std::end(kUnits), [&](const Unit& u) {
    return u.quantity == quantity && u.multiple == 1 && u.power_of_ten == 0;
  });
  return unit->name;
}

// "name [unit]" -> {name, unit}; the unit is empty where there is none.
std::pair<std::string, std::string> NameAndUnit(const std::string& cell) {
  const std::size_t open = cell.find('[');
  if (open == std::string::npos || cell.back() != ']') return {cell, ""};
  const std::size_t last = cell.find_last_not_of(' ', open == 0 ? 0 : open - 1);
  return {cell.substr(0, open == 0 ? 0 : last + 1), cell.substr(open + 1, cell.size() - open - 2)};
}

const Unit& UnitOf(const CsvLines& lines, const MeasuredColumn& column, const std::string& name) {
  const Unit* const unit = FindUnit(column.quantity, name);
  if (unit != nullptr) return *unit;
  lines.Refuse("column " + column.name + " must state its unit as " + column.name +
               " [unit], one of " + UnitsOf(column.quantity) + ", got \"" + name + "\"");
}

// Where a cell of a row goes and in what unit it stands.
struct Place {
  std::size_t column;
  const Unit& unit;
};

std::string NamesOf(const std::vector<MeasuredColumn>& columns) {
  std::vector<std::string> names;
  for (const MeasuredColumn& column : columns) names.push_back(column.name);
  return Listed(names);
}

std::vector<Place> ReadHeader(CsvLines& lines, const std::vector<MeasuredColumn>& columns) {
  std::vector<std::string> header;
  if (!lines.Next(&header)) lines.Refuse("the line with the names of the columns is missing");
  std::vector<Place> places;
  std::vector<bool> found(columns.size(), false);
  for (const std::string& cell : header) {
    const auto [name, unit] = NameAndUnit(cell);
    std::size_t c = 0;
    while (c < columns.size() && columns[c].name != name) ++c;
    if (c == columns.size()) {
      lines.Refuse("unknown column \"" + name + "\"; the columns are: " + NamesOf(columns));
    }
    if (found[c]) lines.Refuse("column \"" + name + "\" stands here a second time");
    found[c] = true;
    places.push_back({c, UnitOf(lines, columns[c], unit)});
  }
  for (std::size_t c = 0; c < columns.size(); ++c) {
    if (!found[c] && !columns[c].optional)
      lines.Refuse("column " + columns[c].name + " is missing");
  }
  return places;
}

}  // namespace

const Unit* FindUnit(Quantity quantity, const std::string& name) {
  const auto* unit = std::find_if(std::begin(kUnits), std::end(kUnits), [&](const Unit& u) {
    return u.quantity == quantity && u.name == name;
  });
  return unit != std::end(kUnits) ? unit : nullptr;
}

double InSi(double value, const Unit& unit) {
  return WithPointMoved(value * unit.multiple, unit.power_of_ten);
}

std::string UnitsOf(Quantity quantity) {
  std::vector<std::string> names;
  for (const Unit& unit : kUnits) {
    if (unit.quantity == quantity) names.push_back(unit.name);
  }
  return Listed(names);
}

Measurements::Measurements(const std::string& file, const std::vector<MeasuredColumn>& columns,
                           std::size_t least_rows)
    : file_(file), columns_(columns), values_(columns.size()) {
  CsvLines lines(file);
  const std::vector<Place> places = ReadHeader(lines, columns_);
  std::vector<std::string> cells;
  while (lines.Next(&cells)) {
    lines.RequireWidth(cells, places.size());
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const auto& [column, unit] = places[i];
      const std::string& name = columns_[column].name;
      values_[column].push_back(InSi(lines.Number(name, cells[i]), unit));
      if (std::isfinite(values_[column].back())) continue;
      lines.Refuse(name + " is too large, got " + cells[i] + " " + unit.name);
    }
    lines_.push_back(lines.line());
  }
  if (rows() < least_rows) {
    lines.Refuse("there must be at least " + std::to_string(least_rows) + " rows, got " +
                 std::to_string(rows()));
  }
}

std::size_t Measurements::IndexOf(const std::string& name) const {
  std::size_t c = 0;
  while (columns_[c].name != name) ++c;
  return c;
}

const std::vector<double>& Measurements::Column(const std::string& name) const {
  return values_[IndexOf(name)];
}

void Measurements::Refuse(std::size_t row, const std::string& rule) const {
  throw InputError(file_ + ":" + std::to_string(lines_[row]) + ": " + rule);
}

void Measurements::Require(const std::string& name, const char* rule, bool (*holds)(double)) const {
  const std::size_t c = IndexOf(name);
  const std::string unit = " " + SiUnitOf(columns_[c].quantity);
  for (std::size_t row = 0; row < values_[c].size(); ++row) {
    if (holds(values_[c][row])) continue;
    Refuse(row, name + " must be " + rule + unit + ", got " + Shown(values_[c][row]) + unit);
  }
}

void Measurements::RequireNotNegative(const std::string& name) const {
  Require(name, ">= 0", [](double value) { return value >= 0; });
}

void Measurements::RequirePositive(const std::string& name) const {
  Require(name, "> 0", [](double value) { return value > 0; });
}

}  // namespace softsoil
