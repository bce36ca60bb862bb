// The command line of softsoil fit-tire.
#include <memory>

#include "plugin/cli/commands.h"
#include "plugin/cli/fit_tire.h"

namespace softsoil {

void AddFitTireCommand(CLI::App& program) {
  CLI::App* command = program.add_subcommand(
      "fit-tire", "Fit a tire's spring to load-deflection data and write its entry");
  auto options = std::make_shared<FitTireOptions>();
  FitTireOptions& o = *options;
  command
      ->add_option("data", o.data,
                   "CSV file with the columns deflection [unit], load [unit] and, for tests at "
                   "several pressures, inflation_pressure [unit]")
      ->required();
  command->add_option("--radius", o.radius, "Outer radius, unloaded [m]")->required();
  command->add_option("--width", o.width, "Width of the tread [m]")->required();
  command->add_option("--crown-radius", o.crown_radius, "Radius of the tire's cross-section [m]");
  command->add_option("--contact-width", o.contact_width,
                      "CSV file with the columns deflection [unit] and contact_width [unit], to "
                      "which the crown radius is fitted");
  command->add_flag("--cylinder", o.cylinder, "The tire has no crown");
  command->add_option(
      "--spring", o.spring,
      "Form to write: linear, quadratic, \"linear + root\", root or cubic; the best "
      "if left out");
  command->add_option("--name", o.name,
                      "Name of the entry, or of the family if data tell pressures");
  command->add_option("--damping", o.damping,
                      "Pressure per speed at which the wheel nears the ground [Pa s/m]");
  command->add_option(
      "--load", o.load,
      "Load on the tire [N]; the damping is estimated as 0.05 of critical under it");
  command->add_option("--friction", o.friction, "Friction between tire and soil [-]");
  command->add_option("--like", o.like, "Tire of the catalogue whose friction is taken");
  command->add_option("--tire-file", o.tire_files, "XML file with more tires")
      ->allow_extra_args(false);
  command->add_option("--out", o.out, "XML file to write the entries to");
  command->add_option("--picture", o.picture, "PNG file: data and fits; beside --out if left out");
  command->add_flag("--no-picture", o.no_picture,
                    "Do not draw it, which needs python3 with matplotlib");
  command->add_flag("--force", o.force, "Overwrite files that are there");
  command->get_option("--damping")->excludes("--load");
  command->get_option("--friction")->excludes("--like");
  command->callback([options] { FitTire(*options); });
}

}  // namespace softsoil
