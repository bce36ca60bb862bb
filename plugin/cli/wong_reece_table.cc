#include "plugin/cli/wong_reece_table.h"

#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "plugin/cli/csv_cell.h"
#include "plugin/cli/standard_output.h"
#include "terrain/constants.h"
#include "terrain/output_file.h"

namespace softsoil {
namespace {

constexpr int kAnglesAlongRim = 181;

struct Column {
  const char* name;  // in wong_reece.csv, with its unit
  double (*value)(const WongReece&);
};

const std::vector<Column>& Columns() {
  using W = WongReece;
  static const std::vector<Column> columns = {
      {"slip [-]", [](const W& w) { return SaeFromSlip(w.slip); }},
      {"slip_i [-]", [](const W& w) { return w.slip; }},
      {"load [N]", [](const W& w) { return w.load; }},
      {"thrust [N]", [](const W& w) { return w.thrust; }},
      {"motion_resistance [N]", [](const W& w) { return w.motion_resistance; }},
      {"drawbar_pull [N]", [](const W& w) { return w.drawbar_pull; }},
      {"torque [N m]", [](const W& w) { return w.torque; }},
      {"sinkage [m]", [](const W& w) { return w.sinkage; }},
      {"entry_angle [deg]", [](const W& w) { return w.entry_angle * kDegrees; }},
      {"max_stress_angle [deg]", [](const W& w) { return w.max_stress_angle * kDegrees; }},
  };
  return columns;
}

const char* Mode(const WongReece& rolling) { return rolling.slip < 0 ? "towed" : "driven"; }

void WriteForces(const WongReeceResults& results, const std::string& folder) {
  OutputFile file(folder + "/wong_reece.csv");
  std::string header = "mode";
  for (const Column& column : Columns()) header += std::string(",") + column.name;
  file.Write(header + "\n");
  for (const WongReece& rolling : results.rolling) {
    std::string row = Mode(rolling);
    for (const Column& column : Columns()) row += "," + CsvCell(column.value(rolling));
    file.Write(row + "\n");
  }
  file.Finish();
}

void WriteStresses(const WongReeceResults& results, const std::string& folder) {
  OutputFile file(folder + "/rim_stress.csv");
  file.Write("mode,slip [-],slip_i [-],angle [deg],pressure [Pa],shear [Pa]\n");
  for (const WongReece& rolling : results.rolling) {
    const std::string start = std::string(Mode(rolling)) + "," +
                              CsvCell(SaeFromSlip(rolling.slip)) + "," + CsvCell(rolling.slip);
    for (const RimStress& s :
         StressAlongRim(results.wheel, results.under_rim, rolling, kAnglesAlongRim)) {
      file.Write(start + "," + CsvCell(s.angle * kDegrees) + "," + CsvCell(s.pressure) + "," +
                 CsvCell(s.shear) + "\n");
    }
  }
  file.Finish();
}

void WriteInputs(const WongReeceResults& results, const std::string& folder) {
  const SoilUnderRim& soil = results.under_rim;
  nlohmann::ordered_json json;
  json["tire"] = results.tire;
  json["soil"] = results.soil;
  json["load"] = results.load;
  json["radius"] = results.wheel.radius;
  json["width"] = results.wheel.width;
  json["bearing_modulus"] = soil.bearing_modulus;
  json["n"] = soil.n;
  json["cohesion"] = soil.shear.cohesion;
  json["friction_angle_deg"] = soil.shear.friction_angle * kDegrees;
  json["shear_modulus"] = soil.shear.modulus;
  json["c_1"] = soil.max_stress.c_1;
  json["c_2"] = soil.max_stress.c_2;
  OutputFile file(folder + "/wong_reece.json");
  file.Write(json.dump(2) + "\n");
  file.Finish();
}

// To a tenth, such that -0.01 is printed as 0.0 and not as -0.0.
double ToTenths(double value) { return std::round(value * 10) / 10 + 0.0; }

}  // namespace

void WriteWongReece(const WongReeceResults& results, const std::string& folder) {
  WriteForces(results, folder);
  WriteStresses(results, folder);
  WriteInputs(results, folder);
}

void PrintWongReece(const WongReeceResults& results) {
  std::printf("%s as a rigid wheel (radius %.4g m, width %.4g m) on %s, load %.6g N\n",
              results.tire.c_str(), results.wheel.radius, results.wheel.width, results.soil.c_str(),
              results.load);
  std::printf("%-6s %14s %9s %10s %21s %16s %12s %12s %17s %19s\n", "mode", "slip ratio [%]",
              "i [%]", "thrust [N]", "motion resistance [N]", "drawbar pull [N]", "torque [N m]",
              "sinkage [cm]", "entry angle [deg]", "max stress at [deg]");
  for (const WongReece& w : results.rolling) {
    std::printf("%-6s %14.1f %9.1f %10.1f %21.1f %16.1f %12.1f %12.1f %17.1f %19.1f\n", Mode(w),
                ToTenths(100 * SaeFromSlip(w.slip)), ToTenths(100 * w.slip), ToTenths(w.thrust),
                ToTenths(w.motion_resistance), ToTenths(w.drawbar_pull), ToTenths(w.torque),
                ToTenths(100 * w.sinkage), ToTenths(w.entry_angle * kDegrees),
                ToTenths(w.max_stress_angle * kDegrees));
  }
  FlushStandardOutput();
}

}  // namespace softsoil
