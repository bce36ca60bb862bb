// softsoil wong-reece: what a tire would do on soil if it were rigid, by plastic equilibrium.
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "contact/tire_family.h"
#include "plugin/cli/catalogues.h"
#include "plugin/cli/commands.h"
#include "plugin/cli/number_range.h"
#include "plugin/cli/picture.h"
#include "plugin/cli/result_folder.h"
#include "plugin/cli/rigid_wheel.h"
#include "plugin/cli/slip_limits.h"
#include "plugin/cli/wong_reece_table.h"
#include "terrain/input_error.h"
#include "terrain/limits.h"
#include "terrain/soil.h"

namespace softsoil {
namespace {

constexpr char kSae[] = "sae", kWongReece[] = "wong-reece";  // definitions of slip

// The command line.
struct Line {
  std::string tire, soil, folder;
  std::vector<std::string> tire_files, soil_files;
  double load = 0;                      // [N]
  std::optional<double> width;          // [m]  the tire's, if not given
  std::optional<double> c_1, c_2;       // [-]  the soil's, if not given
  std::string slip, definition = kSae;  // driven, if given
  bool towed = false, no_picture = false;
};

void CheckPositive(const std::string& option, const std::string& unit, double value) {
  if (value > 0 && std::isfinite(value)) return;
  throw InputError(option + " must be > 0 " + unit + ", got " + Shown(value));
}

void Check(const Line& line) {
  CheckPositive("--load", "N", line.load);
  if (line.width) CheckPositive("--width", "m", *line.width);
  if (line.slip.empty() && !line.towed) {
    throw InputError("--slip for a driven wheel or --towed is required");
  }
}

// Slip i = 1 - v/(r w) of each driven wheel.
std::vector<double> Slips(const Line& line) {
  if (line.slip.empty()) return {};
  const bool sae = line.definition == kSae;
  std::vector<double> slips = NumbersIn("--slip", line.slip);
  for (double& slip : slips) {
    RequireSlip({0, sae ? kMostSlip : SlipFromSae(kMostSlip)}, slip);
    if (sae) slip = SlipFromSae(slip);
  }
  return slips;
}

// A towed wheel needs none.
SoilUnderRim UnderRim(const Soil& soil, double width, const Line& line) {
  std::optional<MaxStress> max_stress = MaxStressGiven(line.c_1, line.c_2);
  const bool needed = !line.slip.empty();
  if (!max_stress && !soil.max_stress && !needed) max_stress = MaxStress{};
  return UnderRim(soil, width, max_stress);
}

WongReeceResults Solve(const Line& line) {
  const Tire tire = FindTire(TiresWith(line.tire_files), line.tire);
  const Soil soil = SoilsWith(line.soil_files).Find(line.soil);
  const RigidWheel wheel = {tire.shape.radius, line.width.value_or(tire.shape.width)};
  const SoilUnderRim under_rim = UnderRim(soil, wheel.width, line);
  WongReeceResults results = {tire.name, soil.name, wheel, under_rim, line.load, {}};
  if (line.towed) {
    results.rolling.push_back(At("towed", [&] { return TowedWheel(wheel, under_rim, line.load); }));
  }
  for (const double slip : Slips(line)) {
    results.rolling.push_back(At("slip ratio " + Shown(SaeFromSlip(slip)),
                                 [&] { return DrivenWheel(wheel, under_rim, line.load, slip); }));
  }
  return results;
}

// Nothing is written before everything is solved.
void Run(const Line& line) {
  Check(line);
  const WongReeceResults results = Solve(line);
  const std::string python = line.no_picture ? "" : PythonThatPlots();
  const ResultFolder folder(
      line.folder, {"wong_reece.csv", "rim_stress.csv", "wong_reece.json", "wong_reece.png"},
      Together(line.tire_files, line.soil_files));
  WriteWongReece(results, line.folder);
  if (!line.no_picture) DrawPictures(python, line.folder, {"wong_reece"});
  PrintWongReece(results);
}

void AddInputs(CLI::App* command, Line* line) {
  command->add_option("--tire", line->tire, "Tire by its name in the catalogue")->required();
  command->add_option("--soil", line->soil, "Soil by its name in the catalogue")->required();
  command->add_option("--load", line->load, "Load on the wheel [N]")->required();
  command->add_option("--out", line->folder, "Folder for the results")->required();
  command->add_option("--tire-file", line->tire_files, "XML file with more tires")
      ->allow_extra_args(false);
  command->add_option("--soil-file", line->soil_files, "XML file with more soils")
      ->allow_extra_args(false);
  command->add_option("--width", line->width, "Width of the wheel [m]; if left out the tire's");
  command->add_option(
      "--c1", line->c_1,
      "Soil presses most at (c1 + c2 i) of the entry angle; if left out the soil's");
  command->add_option("--c2", line->c_2, "See --c1");
  command->add_flag("--no-picture", line->no_picture,
                    "Do not draw, which needs python3 with matplotlib");
}

void AddRolling(CLI::App* command, Line* line) {
  command->add_option("--slip", line->slip,
                      "Slips of the driven wheel: first:last:step or a list, 0.05,0.1");
  command
      ->add_option("--slip-definition", line->definition,
                   "sae: (r w - v)/v, as in all reports; wong-reece: i = 1 - v/(r w)")
      ->check(CLI::IsMember({kSae, kWongReece}))
      ->capture_default_str();
  command->add_flag("--towed", line->towed, "The wheel towed without torque; alone or besides");
}

}  // namespace

void AddWongReeceCommand(CLI::App& program) {
  CLI::App* command = program.add_subcommand(
      "wong-reece", "Pull, torque and sinkage of a rigid wheel on soil by Wong and Reece (1967)");
  command->footer(
      "For example: softsoil wong-reece --tire 18.4R38_85kPa --soil tilled_yolo_loam --load 18000 "
      "--slip 0.05:0.7:0.05 --out wr");
  auto line = std::make_shared<Line>();
  AddInputs(command, line.get());
  AddRolling(command, line.get());
  command->callback([line] { Run(*line); });
}

}  // namespace softsoil
