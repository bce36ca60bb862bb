// The ground of a state file, without the identity and checksum before and after it.
#include "terrain/ground.h"
#include "tests/fuzz/fuzz_target.h"

namespace softsoil {
namespace {

// Small tiles, so that inputs are short.
Ground Undisturbed() {
  Catalogue<Soil> soils = SoilCatalogue();
  soils.AddFile(SOFTSOIL_SOURCE_DIR "/models/soils/yolo_loam.xml");
  GroundSettings settings;
  settings.grid_spacing = settings.volume_height = 0.1;
  settings.volumes = 1;
  settings.sync = true;
  return Ground(
      soils.Find("tilled_yolo_loam"), settings, [](double, double) { return 0.0; }, 2);
}

}  // namespace

void Read(const std::string& text) {
  static const Ground undisturbed = Undisturbed();
  Ground ground = undisturbed;
  StateReader reader(reinterpret_cast<const unsigned char*>(text.data()), text.size());
  ground.Read(reader);
  StateWriter hash;
  ground.Write(hash);
}

}  // namespace softsoil
