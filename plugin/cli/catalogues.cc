#include "plugin/cli/catalogues.h"

#include "plugin/cli/paths.h"

namespace softsoil {

Catalogue<Soil> SoilsWith(const std::vector<std::string>& files) {
  return SoilCatalogue().With(ShareFolder() + "/models/soils", files);
}

Catalogue<Tire> TiresWith(const std::vector<std::string>& files) {
  return TireCatalogue().With(ShareFolder() + "/models/tires", files);
}

}  // namespace softsoil
