// The command line of softsoil soil.
#include <memory>

#include "plugin/cli/commands.h"
#include "plugin/cli/soil_identify.h"

namespace softsoil {
namespace {

void AddComposition(CLI::App& command, SoilOptions& options) {
  command.add_option("--uscs", options.uscs, "USCS class with known data: CH, ML, SW, CL or MH");
  command.add_option("--clay", options.clay, "Share of clay by mass [%]");
  command.add_option("--silt", options.silt, "Share of silt by mass [%]");
  command.add_option("--sand", options.sand, "Share of sand by mass [%]");
  command.add_option("--bulk-density", options.bulk_density,
                     "Measured density of the undisturbed soil [kg/m^3]");
  command.add_option("--saturation", options.saturation,
                     "Share of the pores that water fills, 0 to 1");
  command.add_option("--reference-saturation", options.reference_saturation,
                     "The same for which the virgin curve holds, 0 to 1");
}

void AddTests(CLI::App& command, SoilOptions& options) {
  command.add_option("--plate", options.plate,
                     "CSV file of plate-sinkage tests: width, sinkage, pressure, with units");
  command.add_flag("--reece", options.reece,
                   "Fit k_1, k_2 of Reece to the plates instead of k_c, k_phi of Bekker");
  command.add_flag("--frictional", options.frictional,
                   "Plates of one width: take k_c = 0, the soil being frictional");
  command.add_option(
      "--shear", options.shear,
      "CSV file of shear tests: normal_stress, displacement, shear_stress, with units");
  command.add_option("--like", options.like,
                     "Soil of the catalogue that gives every group that nothing else gives");
}

void AddOutput(CLI::App& command, SoilOptions& options) {
  command.add_option("--name", options.name, "Name of the soil in its entry");
  command.add_option("--description", options.description, "Its description");
  command.add_option("--out", options.out,
                     "XML file to write: a soil for softsoil run --set soil_file=FILE");
  command.add_option("--picture", options.picture,
                     "PNG file: tests against fit; beside --out if left out");
  command.add_flag("--no-picture", options.no_picture,
                   "Do not draw it, which needs python3 with matplotlib");
  command.add_flag("--force", options.force, "Overwrite files that are there");
}

}  // namespace

void AddSoilCommand(CLI::App& program) {
  CLI::App* command = program.add_subcommand(
      "soil", "Identify a soil from its composition and from tests, and write its entry");
  auto options = std::make_shared<SoilOptions>();
  AddComposition(*command, *options);
  AddTests(*command, *options);
  AddOutput(*command, *options);
  command->callback([options] { IdentifySoil(*options); });
}

}  // namespace softsoil
