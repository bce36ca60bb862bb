// The shipped soils and tires, and those of files that the user names.
#pragma once

#include <string>
#include <vector>

#include "contact/tire.h"
#include "terrain/soil.h"

namespace softsoil {

// Throw InputError if a file is bad or holds a name that is taken.
Catalogue<Soil> SoilsWith(const std::vector<std::string>& files = {});
Catalogue<Tire> TiresWith(const std::vector<std::string>& files = {});

// The files of both together.
std::vector<std::string> Together(std::vector<std::string> tire_files,
                                  const std::vector<std::string>& soil_files);

}  // namespace softsoil
