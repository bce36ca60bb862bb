// The command line of softsoil drawbar.
#include <algorithm>
#include <cctype>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "plugin/cli/commands.h"
#include "plugin/cli/drawbar.h"
#include "plugin/cli/number_range.h"
#include "plugin/cli/rigid_wheel.h"
#include "terrain/input_error.h"
#include "terrain/processors.h"

namespace softsoil {
namespace {

constexpr int kMostThreads = 1024;

// Keys that have an option of their own, and what it is.
const std::map<std::string, std::string>& Reserved() {
  static const std::map<std::string, std::string> reserved = {
      {"soil", "--soil"},           {"tire", "--tire"},   {"soil_file", "--soil-file"},
      {"tire_file", "--tire-file"}, {"bumps", "--bumps"}, {"threads", "--threads"}};
  return reserved;
}

// The texts of the command line that are not yet what they mean.
struct Line {
  DrawbarOptions options;
  std::string mode = "slip", slip, spin, contact_times;
  std::vector<std::string> settings;
  std::optional<double> c_1, c_2;
  int threads = Processors();
  bool no_picture = false;
  CLI::App* command = nullptr;

  bool Given(const char* option) const { return command->count(option) > 0; }
};

void ReadSetting(const std::string& text, DrawbarOptions* options) {
  const std::size_t equals = text.find('=');
  const bool blank =
      std::any_of(text.begin(), text.end(), [](unsigned char c) { return std::isspace(c) != 0; });
  if (equals == std::string::npos || equals == 0 || equals + 1 == text.size() || blank) {
    throw InputError("a setting must be KEY=VALUE without blanks, got \"" + text + "\"");
  }
  const std::string key = text.substr(0, equals);
  const auto reserved = Reserved().find(key);
  if (reserved != Reserved().end()) {
    throw InputError("--set " + key + ": is chosen by " + reserved->second);
  }
  for (const auto& given : options->settings) {
    if (given.first == key) throw InputError("--set " + key + ": is given twice");
  }
  options->settings.emplace_back(key, text.substr(equals + 1));
}

// Options that one mode needs, and that no other mode has a use for.
void CheckMode(const Line& line) {
  static const std::vector<std::pair<const char*, const char*>> needed = {
      {"--slip", "slip"}, {"--spin", "spin"}, {"--torque", "torque"}, {"--time", "torque"}};
  static const std::vector<std::pair<const char*, const char*>> possible = {
      {"--bumps", "torque"}, {"--contact-times", "torque"}, {"--wong-reece", "slip"}};
  for (const auto& [option, mode] : needed) {
    if (line.mode == mode && !line.Given(option)) {
      throw InputError("--mode " + line.mode + " needs " + option);
    }
  }
  for (const auto* options : {&needed, &possible}) {
    for (const auto& [option, mode] : *options) {
      if (line.mode == mode || !line.Given(option)) continue;
      throw InputError(std::string(option) + " is for --mode " + mode + ", not for --mode " +
                       line.mode);
    }
  }
  for (const char* option : {"--c1", "--c2", "--wong-reece-width"}) {
    if (line.Given(option) && !line.options.wong_reece) {
      throw InputError(std::string(option) + " is for --wong-reece");
    }
  }
  if (line.mode == "torque" && line.Given("--speed")) {
    throw InputError("--speed is for --mode slip and spin, not for --mode torque");
  }
}

BinMode ModeOf(const std::string& name) {
  if (name == "slip") return BinMode::kSlip;
  return name == "spin" ? BinMode::kSpin : BinMode::kTorque;
}

void RunLine(Line* line) {
  CheckMode(*line);
  DrawbarOptions& options = line->options;
  options.mode = ModeOf(line->mode);
  options.max_stress = MaxStressGiven(line->c_1, line->c_2);
  if (options.mode == BinMode::kSlip) options.slips = NumbersIn("--slip", line->slip);
  if (options.mode == BinMode::kSpin) options.spins = NumbersIn("--spin", line->spin);
  if (options.mode == BinMode::kTorque) {
    options.contact_times =
        line->Given("--contact-times")
            ? NumbersIn("--contact-times", line->contact_times)
            : std::vector<double>{0.2 * options.time, 0.6 * options.time, options.time};
  }
  for (const std::string& setting : line->settings) ReadSetting(setting, &options);
  if (line->threads < 1 || line->threads > kMostThreads) {
    throw InputError("--threads must be 1 to " + std::to_string(kMostThreads) + ", got " +
                     std::to_string(line->threads));
  }
  options.threads = line->threads;
  options.picture = !line->no_picture;
  Drawbar(options);
}

void AddInputs(CLI::App* command, Line* line) {
  DrawbarOptions& options = line->options;
  command->add_option("--tire", options.tire, "Tire by its name in the catalogue")->required();
  command->add_option("--soil", options.soil, "Soil by its name in the catalogue")->required();
  command->add_option("--load", options.load, "Load on the wheel [N]")->required();
  command->add_option("--out", options.folder, "Folder for the results")->required();
  command->add_option("--tire-file", options.tire_files, "XML file with more tires")
      ->allow_extra_args(false);
  command->add_option("--soil-file", options.soil_files, "XML file with more soils")
      ->allow_extra_args(false);
  command
      ->add_option("--set", line->settings,
                   "A softsoil_KEY of the model's <custom>, overridden; may be given several times")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
  command
      ->add_option(
          "--threads", line->threads,
          "Cases at a time, or in --mode torque threads of the soil; no influence on results")
      ->capture_default_str();
  command->add_flag("--no-picture", line->no_picture,
                    "Do not draw, which needs python3 with matplotlib");
}

void AddDrives(CLI::App* command, Line* line) {
  DrawbarOptions& options = line->options;
  command
      ->add_option("--mode", line->mode,
                   "What is prescribed: slip; spin, or torque, with free forward motion")
      ->check(CLI::IsMember({"slip", "spin", "torque"}))
      ->capture_default_str();
  command->add_option("--slip", line->slip,
                      "Slip (r w - v)/v against the unloaded radius: first:last:step or a list, "
                      "0.05,0.1,0.3");
  command->add_option("--spin", line->spin, "Spin in --mode spin [rad/s]: as --slip");
  command->add_option("--speed", options.speed, "Forward speed in --mode slip [m/s]")
      ->capture_default_str();
  command->add_flag("--wong-reece", options.wong_reece,
                    "Also the rigid wheel of Wong and Reece, in --mode slip");
  command->add_option("--wong-reece-width", options.rigid_width,
                      "--wong-reece: width of the rigid wheel [m]; if left out the tire's");
  command->add_option(
      "--c1", line->c_1,
      "--wong-reece: soil presses most at (c1 + c2 i) of the entry angle; if left out the soil's");
  command->add_option("--c2", line->c_2, "See --c1");
  command->add_option("--torque", options.torque, "Torque in --mode torque [N m]");
  command->add_option("--time", options.time, "Time to simulate in --mode torque [s]");
  command->add_option("--bumps", options.bumps,
                      "Bumpy ground in --mode torque: height [m], spacing [m] and, if wanted, a "
                      "seed: 0.03,0.5,7");
  command->add_option("--contact-times", line->contact_times,
                      "Times at which --mode torque writes the stress along the centre line [s]: "
                      "as --slip; if left out a fifth, three fifths and the whole of --time");
}

}  // namespace

void AddDrawbarCommand(CLI::App& program) {
  CLI::App* command =
      program.add_subcommand("drawbar", "Drive a tire in the soil bin: pull, torque and sinkage");
  command->footer(
      "For example: softsoil drawbar --tire 18.4R38_85kPa --soil tilled_yolo_loam --load 18000 "
      "--slip 0.05:0.4:0.05 --out bin");
  auto line = std::make_shared<Line>();
  line->command = command;
  AddInputs(command, line.get());
  AddDrives(command, line.get());
  command->callback([line] { RunLine(line.get()); });
}

}  // namespace softsoil
