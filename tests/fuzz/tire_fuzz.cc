// A catalogue of tires, and its families at the pressures that they say they have.
#include "contact/tire.h"
#include "contact/tire_family.h"
#include "tests/fuzz/fuzz_target.h"

void softsoil::Read(const std::string& text) {
  Catalogue<Tire> tires = TireCatalogue();
  tires.AddText(text, "tires.xml");
  for (const TireFamily& family : TireFamilies(tires)) {
    for (double pressure : {family.lowest, (family.lowest + family.highest) / 2}) {
      FindTire(tires, family.name + kAtPressure + Shown(pressure) + "Pa");
    }
  }
}
