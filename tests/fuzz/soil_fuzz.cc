// A catalogue of soils.
#include "terrain/soil.h"
#include "tests/fuzz/fuzz_target.h"

void softsoil::Read(const std::string& text) { SoilCatalogue().AddText(text, "soils.xml"); }
