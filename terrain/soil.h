// A soil: every parameter that the laws of this folder need.
#pragma once

#include <string>
#include <vector>

#include "terrain/bearing.h"
#include "terrain/compaction.h"
#include "terrain/shear.h"
#include "terrain/xml_catalogue.h"

namespace softsoil {

struct Soil {
  std::string name, description;
  Bearing bearing;
  Shear shear;
  Compaction compaction;
  double concentration_factor;  // [-]  nu of Froehlich, 3 (elastic) to 6 (very soft)
};

// An empty catalogue for files such as models/soils/yolo_loam.xml.
Catalogue<Soil> SoilCatalogue();

// The numbers of a soil file in <bearing>, <shear>, <compaction>, <stress>; and of the optional
// <moisture>, whose three numbers give Compaction::moisture_shift.
const std::vector<Attribute<Soil>>& SoilAttributes();

}  // namespace softsoil
