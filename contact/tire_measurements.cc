#include "contact/tire_measurements.h"

#include <algorithm>

#include "terrain/input_error.h"
#include "terrain/measurements.h"

namespace softsoil {
namespace {

// A record of a test machine has no more; each pressure has a panel of its own in the picture.
constexpr std::size_t kMostRows = 5000, kMostPressures = 12;
constexpr double kNoise = 0.05;  // of the file's greatest load: so much a load may fall

void RequireBelowRadius(const Measurements& table, std::size_t row, double z, double radius) {
  if (z < radius) return;
  table.Refuse(row, "deflection must be < the tire's radius " + Shown(radius) + " m, got " +
                        Shown(z) + " m");
}

// Adds a row to the test of its pressure. Throws if it does not go on from the row before.
void Add(const Measurements& table, std::size_t row, LoadDeflection* test) {
  const double z = table.Column("deflection")[row], load = table.Column("load")[row];
  if (z == 0 && load > 0) {
    table.Refuse(row, "load must be 0 N at deflection 0, where the tire only touches, got " +
                          Shown(load) + " N");
  }
  if (!test->deflection.empty()) {
    if (z <= test->deflection.back()) {
      table.Refuse(row, "deflection must rise from row to row, got " + Shown(z) + " m after " +
                            Shown(test->deflection.back()) + " m");
    }
    const double highest = *std::max_element(test->load.begin(), test->load.end());
    const std::vector<double>& loads = table.Column("load");
    if (load < highest - kNoise * *std::max_element(loads.begin(), loads.end())) {
      table.Refuse(row, "load must rise with deflection, got " + Shown(load) + " N after " +
                            Shown(highest) + " N");
    }
  }
  test->deflection.push_back(z);
  test->load.push_back(load);
}

void RequireEnough(const std::string& file, const PressureTest& test) {
  const std::size_t rows = test.rows.load.size();
  const std::string place =
      test.inflation_pressure > 0 ? "at " + Shown(test.inflation_pressure / 1e3) + " kPa " : "";
  if (rows < kLeastRowsPerPressure) {
    throw InputError(
        file + ": " + place + "there must be at least " + std::to_string(kLeastRowsPerPressure) +
        " rows, one more than the largest form of spring has terms, got " + std::to_string(rows));
  }
  const auto [least, most] = std::minmax_element(test.rows.load.begin(), test.rows.load.end());
  if (*most > *least) return;
  throw InputError(file + ": " + place + "load must rise with deflection, got " + Shown(*least) +
                   " N in every row");
}

}  // namespace

std::vector<PressureTest> ReadLoadDeflection(const std::string& file, double radius) {
  const Measurements table(file,
                           {{"deflection", Quantity::kLength},
                            {"load", Quantity::kForce},
                            {"inflation_pressure", Quantity::kPressure, true}},
                           1);
  if (table.rows() > kMostRows) {
    table.Refuse(kMostRows, "there must be at most " + std::to_string(kMostRows) +
                                " rows; thin them out, the fit would gain nothing");
  }
  table.RequireNotNegative("deflection");
  table.RequireNotNegative("load");
  table.RequirePositive("inflation_pressure");
  const bool several = table.Has("inflation_pressure");
  std::vector<PressureTest> tests;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    RequireBelowRadius(table, row, table.Column("deflection")[row], radius);
    const double pressure = several ? table.Column("inflation_pressure")[row] : 0;
    auto test = std::find_if(tests.begin(), tests.end(), [&](const PressureTest& known) {
      return known.inflation_pressure == pressure;
    });
    if (test == tests.end()) {
      if (tests.size() == kMostPressures) {
        table.Refuse(row, "there must be at most " + std::to_string(kMostPressures) +
                              " inflation pressures");
      }
      test = tests.insert(test, PressureTest{pressure, {}});
    }
    Add(table, row, &test->rows);
  }
  for (const PressureTest& test : tests) RequireEnough(file, test);
  std::sort(tests.begin(), tests.end(), [](const PressureTest& a, const PressureTest& b) {
    return a.inflation_pressure < b.inflation_pressure;
  });
  return tests;
}

ContactWidths ReadContactWidths(const std::string& file, double radius) {
  const Measurements table(
      file, {{"deflection", Quantity::kLength}, {"contact_width", Quantity::kLength}}, 2);
  table.RequirePositive("deflection");
  table.RequirePositive("contact_width");
  for (std::size_t row = 0; row < table.rows(); ++row) {
    RequireBelowRadius(table, row, table.Column("deflection")[row], radius);
  }
  return {table.Column("deflection"), table.Column("contact_width")};
}

}  // namespace softsoil
