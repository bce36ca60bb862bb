// A table of measurements: a CSV file whose header names every column and its unit, such as
// `sinkage [mm], pressure [kPa]`. Numbers are converted to SI when read.
#pragma once

#include <string>
#include <vector>

namespace softsoil {

enum class Quantity { kLength, kForce, kPressure };

// One of a unit is multiple * 10^power_of_ten of the one of SI.
struct Unit {
  const char* name;
  Quantity quantity;
  double multiple;
  int power_of_ten;
};

// The unit of a name such as "kPa"; null if it is none of the quantity's.
const Unit* FindUnit(Quantity quantity, const std::string& name);
// A value in SI. Powers of ten move its decimal point and change no digit: 9 mm are 0.009 m, which
// neither 9 * 0.001 nor, for other readings, a division by 1000 gives. Infinite if too large.
double InSi(double value, const Unit& unit);
// "Pa, kPa, bar, psi"
std::string UnitsOf(Quantity quantity);

struct MeasuredColumn {
  std::string name;
  Quantity quantity;
  bool optional = false;  // the file may lack it
};

class Measurements {
 public:
  // Reads the columns asked for; the file may hold them in any order and in any unit of their
  // quantity, and no others. Throws InputError with file, line, rule and value: a column missing,
  // unknown or twice, without unit or with one of another quantity; a cell that is no number; or
  // fewer than `least_rows` rows.
  Measurements(const std::string& file, const std::vector<MeasuredColumn>& columns,
               std::size_t least_rows);

  std::size_t rows() const { return lines_.size(); }
  // Whether the file has an optional column.
  bool Has(const std::string& name) const { return !Column(name).empty(); }
  // A column [m], [N] or [Pa] by row; empty if the file lacks it.
  const std::vector<double>& Column(const std::string& name) const;

  // Throws InputError with file and line of a row.
  [[noreturn]] void Refuse(std::size_t row, const std::string& rule) const;

  // Throws unless all of a column is >= 0, or > 0.
  void RequireNotNegative(const std::string& name) const;
  void RequirePositive(const std::string& name) const;

 private:
  std::size_t IndexOf(const std::string& name) const;
  void Require(const std::string& name, const char* rule, bool (*holds)(double)) const;

  std::string file_;
  std::vector<MeasuredColumn> columns_;
  std::vector<std::vector<double>> values_;  // by column and row
  std::vector<int> lines_;                   // in the file, by row
};

}  // namespace softsoil
