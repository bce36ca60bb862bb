// The command line of softsoil soil.
#include <memory>

#include "plugin/cli/commands.h"
#include "plugin/cli/soil_identify.h"

namespace softsoil {
namespace {

void AddComposition(CLI::App& command, SoilOptions& options) {
  command.option_defaults()->group("What the soil is made of");
  command.add_option("--uscs", options.uscs, "USCS class with known data: CH, ML, SW, CL or MH");
  command.add_option("--clay", options.clay, "Share of clay by mass [%]");
  command.add_option("--silt", options.silt, "Share of silt by mass [%]");
  command.add_option("--sand", options.sand, "Share of sand by mass [%]");
  command.option_defaults()->group("Its state");
  command.add_option("--bulk-density", options.bulk_density,
                     "Measured density of the undisturbed soil [kg/m^3]");
  command.add_option("--saturation", options.saturation,
                     "Share of the pores that water fills, 0 to 1");
  command.add_option("--reference-saturation", options.reference_saturation,
                     "Saturation of the soil that the virgin curve is of, 0 to 1");
}

void AddTests(CLI::App& command, SoilOptions& options) {
  command.option_defaults()->group("Its tests");
  command.add_option("--plate", options.plate,
                     "CSV file of plate-sinkage tests with the columns width [mm], sinkage [mm], "
                     "pressure [kPa]; other units too");
  command.add_flag("--reece", options.reece,
                   "Fit k_1, k_2 of Reece to the plates instead of k_c, k_phi of Bekker");
  command.add_flag("--frictional", options.frictional,
                   "For plates of one width: take k_c = 0, the soil being frictional");
  command.add_option(
      "--shear", options.shear,
      "CSV file of shear tests with the columns normal_stress [kPa], displacement [mm], "
      "shear_stress [kPa]; other units too");
}

void AddLike(CLI::App& command, SoilOptions& options) {
  command.option_defaults()->group("What nothing of the above tells");
  command.add_option("--like", options.like,
                     "Soil by its name in the catalogue, softsoil list soils, that gives the rest");
  command.add_option("--soil-file", options.soil_files, "XML file with more soils for --like")
      ->allow_extra_args(false);
}

void AddOutput(CLI::App& command, SoilOptions& options) {
  command.option_defaults()->group("Output");
  command.add_option("--name", options.name, "Name of the soil in its entry; needed by --out");
  command.add_option("--description", options.description, "Its description");
  command.add_option("--out", options.out,
                     "XML file to write the entry to, for softsoil run --set soil_file=FILE and "
                     "softsoil drawbar --soil-file FILE; beside it the report, .json");
  command.add_option("--picture", options.picture,
                     "PNG file to draw tests against fit to; if left out beside --out");
  command.add_flag("--no-picture", options.no_picture,
                   "Do not draw, which needs python3 with matplotlib");
  command.add_flag("--force", options.force, "Overwrite files that are there");
}

}  // namespace

void AddSoilCommand(CLI::App& program) {
  CLI::App* command = program.add_subcommand(
      "soil", "Identify a soil from its composition and from tests, and write its entry");
  command->footer(
      "Give what is known; the table says where each parameter comes from. For example:\n"
      "  softsoil soil --uscs CL --bulk-density 1250 --plate plate_sinkage.csv --shear "
      "shear_test.csv --like tilled_yolo_loam --name my_field --out my_field.xml");
  auto options = std::make_shared<SoilOptions>();
  AddComposition(*command, *options);
  AddTests(*command, *options);
  AddLike(*command, *options);
  AddOutput(*command, *options);
  command->callback([options] { IdentifySoil(*options); });
}

}  // namespace softsoil
