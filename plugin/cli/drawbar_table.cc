#include "plugin/cli/drawbar_table.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <iterator>
#include <nlohmann/json.hpp>

#include "plugin/cli/csv_cell.h"
#include "plugin/cli/mujoco_messages.h"
#include "terrain/input_error.h"
#include "terrain/output_file.h"

namespace softsoil {
namespace {

struct Column {
  const char* name;
  const char* unit;
  std::function<std::optional<double>(const DrawbarCase&)> value;
};

const std::vector<Column>& Columns() {
  using Case = DrawbarCase;
  static const std::vector<Column> columns = {
      {"slip", "-", [](const Case& c) { return c.state.wheel.slip_ratio; }},
      {"rolling_slip", "-", [](const Case& c) { return c.rolling_slip; }},
      {"forward_speed", "m/s", [](const Case& c) { return c.state.wheel.forward_speed; }},
      {"spin", "rad/s", [](const Case& c) { return c.state.wheel.spin; }},
      {"thrust", "N", [](const Case& c) { return c.state.wheel.thrust; }},
      {"motion_resistance", "N", [](const Case& c) { return c.state.wheel.motion_resistance; }},
      {"drawbar_pull", "N", [](const Case& c) { return c.state.wheel.drawbar_pull; }},
      {"torque", "N m", [](const Case& c) { return c.state.wheel.torque; }},
      {"power", "W", [](const Case& c) { return c.state.wheel.torque * c.state.wheel.spin; }},
      {"sinkage", "m", [](const Case& c) { return c.state.wheel.sinkage; }},
      {"rut_depth", "m", [](const Case& c) { return c.state.wheel.rut_depth; }},
      {"compaction_volume", "m^3", [](const Case& c) { return c.state.compaction_volume; }},
      {"densified_share", "-", [](const Case& c) { return c.state.densified_share; }},
      {"contact_area", "m^2", [](const Case& c) { return c.state.wheel.contact_area; }},
      {"peak_pressure", "Pa", [](const Case& c) { return c.state.wheel.peak_pressure; }},
      {"load", "N", [](const Case& c) { return c.state.wheel.load; }},
      {"distance", "m", [](const Case& c) { return c.state.distance; }},
      {"steady", "-", [](const Case& c) { return c.state.steady ? 1.0 : 0.0; }},
  };
  return columns;
}

const char* NameOf(BinMode mode) {
  switch (mode) {
    case BinMode::kSlip: return "slip";
    case BinMode::kSpin: return "spin";
    default: return "torque";
  }
}

// What a curve and a history have in common.
nlohmann::ordered_json Inputs(const DrawbarOptions& options, double radius) {
  nlohmann::ordered_json json;
  json["softsoil_version"] = softsoil_version();
  json["mujoco_version"] = mj_versionString();
  json["tire"] = options.tire;
  json["soil"] = options.soil;
  json["load"] = options.load;
  json["mode"] = NameOf(options.mode);
  json["radius"] = radius;
  json["slip_definition"] =
      "(r w - v)/v with the unloaded radius; rolling_slip: the rolling radius";
  return json;
}

void WriteSummary(const DrawbarOptions& options, nlohmann::ordered_json* json) {
  for (const auto& [key, value] : options.settings) (*json)["settings"][key] = value;
  (*json)["units"] = "m, N, N m, s, m/s";
  (*json)["warnings"] = MujocoWarnings();
  OutputFile file(options.folder + "/summary.json");
  file.Write(json->dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
  file.Finish();
}

// With that many decimals, such that -0.01 becomes 0.0 and not -0.0.
std::string Fixed(double value, int decimals) {
  const double scale = std::pow(10.0, decimals);
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", decimals, std::round(value * scale) / scale + 0.0);
  return text;
}

// A last cell beyond the table's columns is a remark.
void PrintRow(const std::vector<std::string>& cells) {
  constexpr int kWidths[] = {8, 8, 8, 8, 10, 8, 8, 8, 8, 8, 10};
  constexpr std::size_t kColumns = std::size(kWidths);
  for (std::size_t k = 0; k < std::min(cells.size(), kColumns); ++k) {
    std::printf("%s%*s", k > 0 ? " " : "", kWidths[k], cells[k].c_str());
  }
  if (cells.size() > kColumns && !cells.back().empty()) std::printf("  %s", cells.back().c_str());
  std::printf("\n");
}

std::string RollingInWords(const std::optional<double>& radius) {
  if (radius) return "Rolling slip refers to its rolling radius, " + Rounded(*radius, 4) + " m";
  return "It does not roll freely and has no rolling radius, hence no rolling slip either";
}

}  // namespace

void WriteDrawbarCsv(const std::string& folder, const std::vector<DrawbarCase>& cases) {
  OutputFile file(folder + "/drawbar.csv");
  std::string line;
  for (const Column& c : Columns()) {
    line += (line.empty() ? "" : ",") + std::string(c.name) + " [" + c.unit + "]";
  }
  file.Write(line + "\n");
  for (const DrawbarCase& one : cases) {
    line.clear();
    for (const Column& c : Columns()) line += (line.empty() ? "" : ",") + CsvCell(c.value(one));
    file.Write(line + "\n");
  }
  file.Finish();
}

void WriteCentreLineCsv(const std::string& folder, const std::string& key,
                        const CentreLines& lines) {
  OutputFile file(folder + "/centre_line.csv");
  file.Write(key + ",angle [deg],pressure [Pa],shear [Pa]\n");
  for (const auto& [value, points] : lines) {
    for (const CentreLinePoint& p : points) {
      file.Write(CsvCell(value) + "," + CsvCell(p.angle) + "," + CsvCell(p.pressure) + "," +
                 CsvCell(p.shear) + "\n");
    }
  }
  file.Finish();
}

void WriteDrawbarSummary(const DrawbarOptions& options, double radius,
                         const DrawbarResult& result) {
  const FreeRolling& rolling = result.rolling;
  nlohmann::ordered_json json = Inputs(options, radius);
  json["speed"] = options.speed;
  json["free_rolling"]["slip"] = rolling.slip;
  if (rolling.rolling_radius) json["free_rolling"]["rolling_radius"] = *rolling.rolling_radius;
  json["free_rolling"]["motion_resistance"] = rolling.motion_resistance;
  json["free_rolling"]["steady"] = rolling.steady;
  json["steady"] = rolling.steady && std::all_of(result.cases.begin(), result.cases.end(),
                                                 [](const auto& c) { return c.state.steady; });
  WriteSummary(options, &json);
}

void WriteHistorySummary(const DrawbarOptions& options, double radius, bool settled) {
  nlohmann::ordered_json json = Inputs(options, radius);
  json["torque"] = options.torque;
  json["time"] = options.time;
  json["bumps"] = options.bumps;
  json["settled"] = settled;
  WriteSummary(options, &json);
}

void PrintDrawbar(const DrawbarOptions& options, double radius, const DrawbarResult& result) {
  std::printf("%s on %s, %g N\n", options.tire.c_str(), options.soil.c_str(), options.load);
  std::printf(
      "Slip is (r w - v)/v against the unloaded radius, %g m. Pulled without torque at %g "
      "m/s, the wheel\nhas %.1f %% of it and %s N of resistance%s.\n%s.\n\n",
      radius, options.speed, 100 * result.rolling.slip,
      Rounded(result.rolling.motion_resistance, 4).c_str(),
      result.rolling.steady ? "" : ", not steady",
      RollingInWords(result.rolling.rolling_radius).c_str());
  PrintRow({"slip", "rolling", "speed", "thrust", "resistance", "pull", "torque", "power",
            "sinkage", "rut", "sunk"});
  PrintRow({"[%]", "slip [%]", "[m/s]", "[N]", "[N]", "[N]", "[N m]", "[W]", "[cm]", "[cm]",
            "[litres]"});
  // Forces to five digits of the load.
  const int fine = std::clamp(4 - static_cast<int>(std::floor(std::log10(options.load))), 0, 6);
  for (const DrawbarCase& c : result.cases) {
    const softsoilWheel& w = c.state.wheel;
    PrintRow({Fixed(100 * w.slip_ratio, 1),
              c.rolling_slip ? Fixed(100 * *c.rolling_slip, 1) : "none", Fixed(w.forward_speed, 3),
              Fixed(w.thrust, fine), Fixed(w.motion_resistance, fine), Fixed(w.drawbar_pull, fine),
              Fixed(w.torque, fine), Fixed(w.torque * w.spin, fine), Fixed(100 * w.sinkage, 2),
              Fixed(100 * w.rut_depth, 2), Rounded(1000 * c.state.compaction_volume, 4),
              c.state.steady ? "" : "not steady"});
  }
  std::printf("\n");
}

}  // namespace softsoil
