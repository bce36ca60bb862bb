#include "plugin/cli/drawbar.h"

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <system_error>

#include "contact/tire_family.h"
#include "plugin/cli/bin_rig.h"
#include "plugin/cli/catalogues.h"
#include "plugin/cli/drawbar_table.h"
#include "plugin/cli/in_parallel.h"
#include "plugin/cli/mujoco_messages.h"
#include "plugin/cli/picture.h"
#include "plugin/cli/result_folder.h"
#include "plugin/cli/rigid_wheel.h"
#include "plugin/cli/slip_limits.h"
#include "plugin/cli/standard_output.h"
#include "plugin/cli/torque_history.h"
#include "terrain/input_error.h"
#include "terrain/limits.h"
#include "terrain/output_file.h"
#include "terrain/soil.h"

namespace softsoil {
namespace {

constexpr std::size_t kMostCases = 200;
constexpr Limits kLoadLimits = {0.1, 1e7};          // [N]
constexpr Limits kSpeedLimits = {0.01, 100};        // [m/s]    slip is not defined below
constexpr Limits kSlipLimits = {-0.99, kMostSlip};  // [-]  -1 is a locked wheel
constexpr Limits kSpinLimits = {0.01, 1000};        // [rad/s]
constexpr Limits kTorqueLimits = {1e-3, 1e7};       // [N m]
constexpr Limits kTimeLimits = {0.1, 10000};        // [s]
constexpr Limits kWidthLimits = {0.001, 10};        // [m]

constexpr double kHardlyTurns = 0.9;   // [-]    slip, driven or not, of a wheel that does not roll
constexpr double kStandstill = 0.005;  // [m/s]  below any speed that can be asked for

void Require(const char* option, Limits limits, const char* unit, double value) {
  if (Contains(limits, value)) return;
  throw InputError(std::string(option) + " must be " + InWords(limits) + unit + ", got " +
                   Shown(value));
}

void RequireCount(const char* option, const std::vector<double>& values) {
  if (values.empty() || values.size() > kMostCases) {
    throw InputError(std::string(option) + " must be 1 to " + std::to_string(kMostCases) +
                     " numbers, got " + std::to_string(values.size()));
  }
}

void RequireAll(const char* option, Limits limits, const char* unit,
                const std::vector<double>& values) {
  RequireCount(option, values);
  for (const double value : values) Require(option, limits, unit, value);
}

// Commas separate the files in the model.
void RequireNoComma(const char* option, const std::vector<std::string>& files) {
  for (const std::string& file : files) {
    std::error_code none;  // an empty name has no path; the catalogue refuses it
    const std::string path = std::filesystem::absolute(file, none).string();
    if (path.find(',') == std::string::npos) continue;
    throw InputError(std::string(option) + ": the path must not hold a comma, got \"" + path +
                     "\"");
  }
}

void Check(const DrawbarOptions& options) {
  RequireNoComma("--tire-file", options.tire_files);
  RequireNoComma("--soil-file", options.soil_files);
  Require("--load", kLoadLimits, " N", options.load);
  if (options.rigid_width) {
    Require("--wong-reece-width", kWidthLimits, " m", *options.rigid_width);
  }
  if (options.mode == BinMode::kTorque) {
    Require("--torque", kTorqueLimits, " N m", options.torque);
    Require("--time", kTimeLimits, " s", options.time);
    RequireAll("--contact-times", {0, options.time}, " s", options.contact_times);
    return;
  }
  Require("--speed", kSpeedLimits, " m/s", options.speed);
  if (options.mode == BinMode::kSlip) {
    RequireCount("--slip", options.slips);
    for (const double slip : options.slips) RequireSlip(kSlipLimits, slip);
  }
  if (options.mode == BinMode::kSpin) RequireAll("--spin", kSpinLimits, " rad/s", options.spins);
}

// Absolute, as the model may be opened from another folder.
void AddFiles(const char* key, const std::vector<std::string>& files, SoilBin* bin) {
  std::string list;
  for (const std::string& file : files) {
    list += (list.empty() ? "" : ",") + std::filesystem::absolute(file).string();
  }
  if (!list.empty()) bin->settings.emplace_back(key, list);
}

SoilBin BinOf(const DrawbarOptions& options, const Tire& tire) {
  SoilBin bin;
  bin.tire = tire;
  bin.soil = options.soil;
  bin.load = options.load;
  bin.mode = options.mode;
  bin.settings = options.settings;
  AddFiles("tire_file", options.tire_files, &bin);
  AddFiles("soil_file", options.soil_files, &bin);
  if (!options.bumps.empty()) bin.settings.emplace_back("bumps", options.bumps);
  return bin;
}

const std::vector<std::string> kResults = {"soil_bin.xml",    "drawbar.csv",     "history.csv",
                                           "centre_line.csv", "wong_reece.csv",  "rim_stress.csv",
                                           "summary.json",    "wong_reece.json", "drawbar.png",
                                           "centre_line.png", "history.png"};

void WriteModel(const DrawbarOptions& options, const SoilBin& bin) {
  OutputFile file(options.folder + "/soil_bin.xml");
  file.Write(SoilBinModel(bin));
  file.Finish();
}

// On soil without strength a wheel that is pulled hardly turns: it has no rolling radius.
FreeRolling RollingAt(const SteadyState& state) {
  const softsoilWheel& w = state.wheel;
  FreeRolling rolling = {w.slip_ratio, {}, w.motion_resistance, state.steady, state.distance};
  if (std::abs(w.slip_ratio) <= kHardlyTurns) rolling.rolling_radius = w.forward_speed / w.spin;
  return rolling;
}

std::optional<double> RollingSlip(const std::optional<double>& radius, const softsoilWheel& w) {
  if (!radius || w.forward_speed < kStandstill) return {};
  return *radius * w.spin / w.forward_speed - 1;
}

// The cases of a curve: first the freely rolling wheel, then those that are asked for.
class Curve {
 public:
  Curve(const DrawbarOptions& options, const SoilBin& bin) : options_(options), bin_(bin) {
    freely_rolling_ = bin;
    freely_rolling_.mode = BinMode::kSlip;
  }

  DrawbarResult Run() {
    states_.resize(1 + Asked().size());
    InParallel(static_cast<int>(states_.size()), options_.threads, [this](int i) { RunCase(i); });
    DrawbarResult result;
    result.rolling = RollingAt(states_[0]);
    for (std::size_t i = 1; i < states_.size(); ++i) {
      const std::optional<double> slip =
          RollingSlip(result.rolling.rolling_radius, states_[i].wheel);
      result.cases.push_back({Asked()[i - 1], states_[i], slip});
    }
    return result;
  }

 private:
  const std::vector<double>& Asked() const {
    return options_.mode == BinMode::kSlip ? options_.slips : options_.spins;
  }

  void RunCase(int i) {
    BinDrive drive;
    if (i == 0 || options_.mode == BinMode::kSlip) drive.speed = options_.speed;
    if (i > 0) {
      const double asked = Asked()[i - 1];
      drive.spin = options_.mode == BinMode::kSlip
                       ? (1 + asked) * options_.speed / bin_.tire.shape.radius
                       : asked;
    }
    const auto rig = MakeRig(i == 0 ? freely_rolling_ : bin_, 1);
    states_[i] = DriveToSteadyState(drive, bin_.tire, options_.load, rig.get());
  }

  const DrawbarOptions& options_;
  const SoilBin& bin_;
  SoilBin freely_rolling_;
  std::vector<SteadyState> states_;
};

void Warn(const std::string& words) {
  std::fprintf(stderr, "softsoil: warning: %s\n", words.c_str());
}

void SayWhatIsNotSteady(const DrawbarResult& result) {
  const FreeRolling& rolling = result.rolling;
  if (!rolling.steady) {
    Warn("not steady after " + Rounded(rolling.distance, 2) +
         " m: the wheel without torque, to which rolling_slip refers");
  }
  if (!rolling.rolling_radius) {
    Warn("the wheel does not roll freely: without torque its slip is " + Rounded(rolling.slip, 3) +
         "; it has no rolling radius, and rolling_slip is left empty");
  }
  for (const DrawbarCase& c : result.cases) {
    if (c.state.steady) continue;
    Warn("not steady after " + Rounded(c.state.distance, 2) + " m: slip " +
         Rounded(c.state.wheel.slip_ratio, 3));
  }
}

void RunCurve(const DrawbarOptions& options, const SoilBin& bin, const WongReeceResults& rigid) {
  const DrawbarResult result = Curve(options, bin).Run();
  SayWhatIsNotSteady(result);
  CentreLines lines;
  for (const DrawbarCase& c : result.cases) {
    lines.emplace_back(c.asked, c.state.centre_line);
  }
  WriteModel(options, bin);
  const bool by_slip = options.mode == BinMode::kSlip;
  WriteCentreLineCsv(options.folder, by_slip ? "slip [-]" : "spin [rad/s]", lines);
  if (options.wong_reece) WriteWongReece(rigid, options.folder);
  WriteDrawbarSummary(options, bin.tire.shape.radius, result);
  WriteDrawbarCsv(options.folder, result.cases);
  PrintDrawbar(options, bin.tire.shape.radius, result);
}

void RunHistory(const DrawbarOptions& options, const SoilBin& bin) {
  const auto rig = MakeRig(bin, options.threads);
  const TorqueHistory history = DriveByTorque(options, bin.tire, rig.get());
  if (!history.settled) Warn("the wheel had not settled when the torque set in");
  WriteModel(options, bin);
  WriteCentreLineCsv(options.folder, "time [s]", history.centre_lines);
  WriteHistorySummary(options, bin.tire.shape.radius, history.settled);
  const softsoilWheel w = rig->Wheel(0);
  std::printf("%s on %s, %g N, driven by %g N m: after %g s %.3f m/s at %.1f %% slip\n\n",
              options.tire.c_str(), options.soil.c_str(), options.load, options.torque,
              options.time, w.forward_speed, 100 * w.slip_ratio);
}

}  // namespace

void Drawbar(const DrawbarOptions& options) {
  Check(options);
  const Soil soil = SoilsWith(options.soil_files).Find(options.soil);
  const Tire tire = FindTire(TiresWith(options.tire_files), options.tire);
  const SoilBin bin = BinOf(options, tire);
  WongReeceResults rigid;
  if (options.wong_reece) rigid = RigidWheelBeside(tire, soil, options);
  const std::string python = options.picture ? PythonThatPlots() : "";
  HandleMujocoMessages();
  MakeRig(bin, 1);  // refuses bad settings
  const ResultFolder folder(options.folder, kResults,
                            Together(options.tire_files, options.soil_files));
  const bool curve = options.mode != BinMode::kTorque;
  try {
    curve ? RunCurve(options, bin, rigid) : RunHistory(options, bin);
  } catch (...) {
    folder.Clear();
    throw;
  }
  if (options.picture) DrawPictures(python, options.folder, {"drawbar"});
  const std::string name = curve ? "drawbar" : "history";
  std::string files = "summary.json, " + name + ".csv, centre_line.csv, soil_bin.xml";
  if (options.wong_reece) files += ", wong_reece.csv, wong_reece.json, rim_stress.csv";
  if (options.picture) files += ", " + name + ".png, centre_line.png";
  std::printf("Results in %s: %s\n", options.folder.c_str(), files.c_str());
  FlushStandardOutput();
}

}  // namespace softsoil
