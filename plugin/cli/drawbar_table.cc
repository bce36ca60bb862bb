#include "plugin/cli/drawbar_table.h"

#include <cstdio>
#include <nlohmann/json.hpp>

#include "plugin/cli/csv_cell.h"
#include "plugin/cli/mujoco_messages.h"
#include "plugin/cli/output_file.h"

namespace softsoil {
namespace {

struct Column {
  const char* name;
  const char* unit;
  double (*value)(const DrawbarCase&);
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
      {"compaction_volume", "m^3", [](const Case& c) { return c.state.sunk_volume; }},
      {"densified_share", "-", [](const Case& c) { return c.state.compacted_share; }},
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

void WriteDrawbarSummary(const DrawbarOptions& options, double radius, const FreeRolling* rolling) {
  nlohmann::ordered_json json;
  json["softsoil_version"] = softsoil_version();
  json["mujoco_version"] = mj_versionString();
  json["tire"] = options.tire;
  json["soil"] = options.soil;
  json["load"] = options.load;
  json["mode"] = NameOf(options.mode);
  json["radius"] = radius;
  if (options.mode == BinMode::kTorque) {
    json["torque"] = options.torque;
    json["time"] = options.time;
    json["bumps"] = options.bumps;
  } else {
    json["speed"] = options.speed;
  }
  if (rolling != nullptr) {
    json["free_rolling"] = {{"slip", rolling->slip},
                            {"rolling_radius", rolling->rolling_radius},
                            {"motion_resistance", rolling->motion_resistance}};
  }
  for (const auto& [key, value] : options.settings) json["settings"][key] = value;
  json["units"] = "m, N, N m, s, m/s";
  json["warnings"] = MujocoWarnings();
  OutputFile file(options.folder + "/summary.json");
  file.Write(json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
  file.Finish();
}

void PrintDrawbar(const DrawbarOptions& options, double radius, const DrawbarResult& result) {
  std::printf("%s on %s, %g N\n", options.tire.c_str(), options.soil.c_str(), options.load);
  std::printf(
      "Slip is (r w - v)/v against the unloaded radius, %g m. Rolling freely at %g m/s, the wheel\n"
      "has %.1f %% of it, a rolling radius of %.3f m, to which rolling slip refers, and %.0f N of "
      "resistance.\n\n",
      radius, options.speed, 100 * result.rolling.slip, result.rolling.rolling_radius,
      result.rolling.motion_resistance);
  std::printf("%8s %8s %8s %8s %10s %8s %8s %8s %8s %8s %10s\n", "slip", "rolling", "speed",
              "thrust", "resistance", "pull", "torque", "power", "sinkage", "rut", "compaction");
  std::printf("%8s %8s %8s %8s %10s %8s %8s %8s %8s %8s %10s\n", "[%]", "slip [%]", "[m/s]", "[N]",
              "[N]", "[N]", "[N m]", "[W]", "[cm]", "[cm]", "[litres]");
  for (const DrawbarCase& c : result.cases) {
    const softsoilWheel& w = c.state.wheel;
    std::printf("%8.1f %8.1f %8.3f %8.0f %10.0f %8.0f %8.0f %8.0f %8.2f %8.2f %10.2f%s\n",
                100 * w.slip_ratio, 100 * c.rolling_slip, w.forward_speed, w.thrust,
                w.motion_resistance, w.drawbar_pull, w.torque, w.torque * w.spin, 100 * w.sinkage,
                100 * w.rut_depth, 1000 * c.state.sunk_volume,
                c.state.steady ? "" : "  not steady");
  }
  std::printf("\n");
}

}  // namespace softsoil
