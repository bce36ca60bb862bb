// softsoil soil: identifies a soil and writes its entry, its report and the picture of its tests.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace softsoil {

// The command line; what is absent was not given.
struct SoilOptions {
  std::optional<std::string> uscs;
  std::optional<double> clay, silt, sand;                  // [%]
  std::optional<double> bulk_density;                      // [kg/m^3]
  std::optional<double> saturation, reference_saturation;  // [-]
  std::optional<std::string> plate, shear;                 // CSV files
  bool reece = false, frictional = false;
  std::optional<std::string> like;      // name in the catalogue
  std::vector<std::string> soil_files;  // XML, more soils for `like`
  std::string name;
  std::string description;
  std::optional<std::string> out, picture;
  bool no_picture = false, force = false;
};

// Prints the table and writes the files. Throws InputError before anything is written.
void IdentifySoil(const SoilOptions& options);

}  // namespace softsoil
