#include "terrain/soil_entry.h"

#include <gtest/gtest.h>

#include "terrain/input_error.h"
#include "tests/terrain/catalogue_case.h"
#include "tests/terrain/test_soil.h"

namespace softsoil {
namespace {

SoilEntry Entry() {
  SoilEntry entry;
  entry.soil = LooseSoil();
  entry.soil.description = "loam & <clay>";
  for (const char* element : {"bearing", "unloading", "shear", "compaction", "layers", "moisture",
                              "stress", "max_stress"}) {
    entry.source[element] = std::string("a test of ") + element;
  }
  return entry;
}

// A soil with everything that a soil may have.
SoilEntry FullEntry() {
  SoilEntry entry = Entry();
  entry.soil.bearing = {20e3, 400e3, 1.1, BearingForm::kReece};
  entry.soil.unloading = {1.5e6, 2.5e8};
  entry.soil.shear.form = ShearForm::kHumped;
  entry.soil.shear.residual = 0.3;
  entry.soil.slip_sinkage = 0.2;
  entry.soil.layers = {{0.15, 1350}, {0.3, 1500}};
  entry.soil.max_stress = MaxStress{0.43, 0.32};
  entry.moisture = {530, 0.6, 0.4};
  entry.soil.compaction.moisture_shift = 106;
  return entry;
}

Soil ReadBack(const SoilEntry& entry) {
  const std::string path = WriteFile("entry.xml", SoilXml(entry));
  Catalogue<Soil> catalogue = SoilCatalogue();
  catalogue.AddFile(path);
  return catalogue.Find(entry.soil.name);
}

void ExpectSameTable(Soil a, Soil b) {
  ASSERT_EQ(a.bearing.form, b.bearing.form);
  for (const Attribute<Soil>& attribute : SoilAttributes(a.bearing.form)) {
    const double value = attribute.field(a);
    EXPECT_NEAR(attribute.field(b), value, 1e-6 * value) << attribute.name;
  }
}

TEST(SoilXml, IsReadBackByTheCatalogue) {
  const SoilEntry entry = Entry();
  const Soil soil = ReadBack(entry);
  EXPECT_EQ(soil.description, entry.soil.description);
  ExpectSameTable(entry.soil, soil);
  EXPECT_TRUE(soil.unloading.IsRigid());
  EXPECT_TRUE(soil.layers.empty());
  EXPECT_FALSE(soil.max_stress);
}

TEST(SoilXml, KeepsEveryFormThatASoilMayHave) {
  const SoilEntry entry = FullEntry();
  const Soil soil = ReadBack(entry);
  ExpectSameTable(entry.soil, soil);
  EXPECT_EQ(soil.unloading.k_0, 1.5e6);
  EXPECT_EQ(soil.unloading.A_u, 2.5e8);
  EXPECT_EQ(soil.shear.form, ShearForm::kHumped);
  EXPECT_EQ(soil.shear.residual, 0.3);
  EXPECT_EQ(soil.slip_sinkage, 0.2);
  ASSERT_EQ(soil.layers.size(), 2u);
  EXPECT_EQ(soil.layers[1].top, 0.3);
  EXPECT_EQ(soil.layers[1].density, 1500);
  EXPECT_EQ(soil.max_stress->c_1, 0.43);
  EXPECT_NEAR(soil.compaction.moisture_shift, 106, 1e-9);
}

TEST(Rounded, KeepsSignificantDigitsWithoutExponent) {
  EXPECT_EQ(Rounded(2096381.7, 4), "2096000");
  EXPECT_EQ(Rounded(0.0197226, 3), "0.0197");
  EXPECT_EQ(Rounded(31.100000000000001, 7), "31.1");
  EXPECT_EQ(Rounded(0, 3), "0");
}

}  // namespace
}  // namespace softsoil
