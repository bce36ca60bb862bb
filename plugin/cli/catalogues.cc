#include "plugin/cli/catalogues.h"

#include "plugin/cli/paths.h"

namespace softsoil {

Catalogue<Soil> SoilsWith(const std::vector<std::string>& files) {
  return SoilCatalogue().With(ShareFolder() + "/models/soils", files);
}

Catalogue<Tire> TiresWith(const std::vector<std::string>& files) {
  return TireCatalogue().With(ShareFolder() + "/models/tires", files);
}

std::vector<std::string> Together(std::vector<std::string> tire_files,
                                  const std::vector<std::string>& soil_files) {
  tire_files.insert(tire_files.end(), soil_files.begin(), soil_files.end());
  return tire_files;
}

}  // namespace softsoil
