#include "plugin/cli/summary.h"

#include <mujoco/mujoco.h>
#include <sys/resource.h>

#include <cinttypes>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <nlohmann/json.hpp>

#include "plugin/cli/mujoco_messages.h"
#include "plugin/cli/standard_output.h"
#include "terrain/output_file.h"

namespace softsoil {
namespace {

using Json = nlohmann::ordered_json;

double RealTimeFactor(const RunResult& result) { return result.wall_time / result.simulated_time; }

// [MB] of this process
double PeakMemory() {
  rusage usage = {};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss * 1024 / 1e6;
}

// 0 before anything is touched.
double Share(std::size_t bytes, std::size_t parts) {
  return parts > 0 ? static_cast<double>(bytes) / parts : 0.0;
}

std::string Hexadecimal(std::uint64_t number) {
  char text[17];
  std::snprintf(text, sizeof text, "%016" PRIx64, number);
  return text;
}

Json WheelSummary(const WheelResult& wheel) {
  Json json;
  json["name"] = wheel.name;
  const std::vector<double> values = wheel.mean.Values();
  for (std::size_t c = 0; c < values.size(); ++c) json[KeyOf(WheelColumns()[c])] = values[c];
  return json;
}

Json WheelUnits() {
  Json units;
  for (const WheelColumn& column : WheelColumns()) units[KeyOf(column)] = column.unit;
  return units;
}

Json Seconds(const TimeShares& shares) {
  Json json = Json::object();
  for (const auto& [name, time] : shares) json[name] = time;
  return json;
}

void PrintProfile(const RunProfile& profile) {
  const auto print = [](const char* whole, const TimeShares& shares) {
    std::printf("%s", whole);
    for (const auto& [name, time] : shares) std::printf("  %s %.2f s", name.c_str(), time);
    std::printf("\n");
  };
  print("Wall time: ", profile.run);
  print("Soil update: ", profile.soil_update);
}

double CompactionEnergy(const RunResult& result) {
  double energy = 0;
  for (const WheelResult& wheel : result.wheels) energy += wheel.mean.Value("compaction_energy");
  return energy;
}

void PrintWheel(const WheelResult& wheel) {
  // Rounded here, such that -0.01 becomes 0.0 and not -0.0.
  const auto value = [&wheel](const char* key, double unit, int digits) {
    const double scale = std::pow(10.0, digits);
    return std::round(wheel.mean.Value(key) / unit * scale) / scale + 0.0;
  };
  std::printf("%-16s %8.1f %12.1f %14.1f %8.1f %16.1f %12.1f\n", wheel.name.c_str(),
              value("load", 1, 1), value("sinkage", 1e-2, 1), value("rut_depth", 1e-2, 1),
              value("slip_ratio", 1e-2, 1), value("drawbar_pull", 1, 1), value("torque", 1, 1));
}

}  // namespace

void WriteSummary(const RunOptions& options, const RunResult& result) {
  const softsoilGround& ground = result.ground;
  Json json;
  json["softsoil_version"] = softsoil_version();
  json["mujoco_version"] = mj_versionString();
  json["scene"] = options.scene;
  json["soil"] = ground.soil;
  json["settings"] = options.settings;
  json["timestep"] = result.time_step;
  json["soil_clock"] = ground.soil_clock;
  json["threads"] = ground.threads;
  json["stress"] = ground.stress;
  json["direct_updates"] = ground.direct_updates;
  json["gaussian_updates"] = ground.gaussian_updates;
  json["start_time"] = result.start_time;
  json["loaded_state"] = options.load_state;
  json["simulated_time"] = result.simulated_time;
  json["wall_time"] = result.wall_time;
  json["real_time_factor"] = RealTimeFactor(result);
  json["peak_memory_mb"] = PeakMemory();
  json["grid_spacing"] = ground.grid_spacing;
  json["columns"] = ground.columns;
  json["volumes"] = ground.volumes;
  json["bytes_per_column"] = Share(ground.bytes - ground.volume_bytes, ground.columns);
  json["bytes_per_volume"] = Share(ground.volume_bytes, ground.volumes);
  json["rut_volume"] = ground.rut_volume;
  json["displaced_volume"] = ground.displaced_volume;
  json["densified_volume"] = ground.densified_volume;
  json["berm_volume"] = ground.berm_volume;
  json["compaction_energy"] = CompactionEnergy(result);
  json["state_hash"] = Hexadecimal(result.state_hash);
  json["wheels_averaged_over"] = result.averaged_over;
  json["wheel_units"] = WheelUnits();
  json["wheels"] = Json::array();
  for (const WheelResult& wheel : result.wheels) json["wheels"].push_back(WheelSummary(wheel));
  json["warnings"] = MujocoWarnings();
  if (result.profile) {
    json["profile"]["run"] = Seconds(result.profile->run);
    json["profile"]["soil_update"] = Seconds(result.profile->soil_update);
  }

  OutputFile file(options.folder + "/summary.json");
  // Names in a model need not be UTF-8; the summary of a long run must not be lost for that.
  file.Write(json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
  file.Finish();
}

void PrintSummary(const RunOptions& options, const RunResult& result) {
  std::printf("%s: %g s on %s", options.scene.c_str(), result.simulated_time, result.ground.soil);
  if (!options.load_state.empty()) {
    std::printf(", from %s at %g s on", options.load_state.c_str(), result.start_time);
  }
  std::printf("; wheels averaged over the last %g s\n\n", result.averaged_over);
  std::printf("%-16s %8s %12s %14s %8s %16s %12s\n", "wheel", "load [N]", "sinkage [cm]",
              "rut depth [cm]", "slip [%]", "drawbar pull [N]", "torque [N m]");
  for (const WheelResult& wheel : result.wheels) PrintWheel(wheel);
  std::printf(
      "\nReal-time factor %.2f (wall / simulated time): %.1f s for %g s with %d thread%s; "
      "%.0f MB\n",
      RealTimeFactor(result), result.wall_time, result.simulated_time, result.ground.threads,
      result.ground.threads == 1 ? "" : "s", PeakMemory());
  std::printf("Stress %s: %zu soil updates direct, %zu gaussian\n", result.ground.stress,
              result.ground.direct_updates, result.ground.gaussian_updates);
  std::printf("Rut volume %.3f m^3, compaction energy %.2f kJ, state hash %s\n",
              result.ground.rut_volume, CompactionEnergy(result) / 1e3,
              Hexadecimal(result.state_hash).c_str());
  if (result.profile) PrintProfile(*result.profile);
  std::printf("Results in %s: summary.json, wheels.csv, contact.csv, terrain.npy%s%s\n",
              options.folder.c_str(), options.picture ? ", terrain.png, contact.png" : "",
              options.picture && options.profile ? ", profile.png" : "");
  FlushStandardOutput();
}

}  // namespace softsoil
