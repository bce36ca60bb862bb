// The soils that come with the program, and how they are found by name.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "tests/terrain/soil_file_case.h"

namespace softsoil {
namespace {

Catalogue<Soil> Shipped() {
  Catalogue<Soil> soils = SoilCatalogue();
  soils.AddFolder(SOFTSOIL_SOURCE_DIR "/models/soils");
  return soils;
}

TEST(SoilCatalogue, ReadsEveryFileThatComesWithTheProgram) {
  const Catalogue<Soil> soils = Shipped();
  EXPECT_GE(soils.entries().size(), 7u);
  EXPECT_EQ(soils.Find("tilled_yolo_loam").name, "tilled_yolo_loam");
  EXPECT_EQ(soils.Find("firm_yolo_loam").name, "firm_yolo_loam");
  for (const Soil& soil : soils.entries()) EXPECT_NE(soil.description, "") << soil.name;
}

// Madsen (2014), section 6.1 and Table 6.4.
TEST(SoilCatalogue, HasTheTilledLoamOfTheThesis) {
  const Soil soil = Shipped().Find("tilled_yolo_loam");
  EXPECT_DOUBLE_EQ(soil.bearing.k_c, 6.8e3);
  EXPECT_DOUBLE_EQ(soil.bearing.k_phi, 1134e3);
  EXPECT_DOUBLE_EQ(soil.bearing.n, 0.85);
  EXPECT_DOUBLE_EQ(soil.shear.cohesion, 7.1e3);
  EXPECT_NEAR(soil.shear.friction_angle, 21.17 * std::acos(-1.0) / 180, 1e-12);
  EXPECT_DOUBLE_EQ(soil.shear.modulus, 0.0106);
  EXPECT_DOUBLE_EQ(soil.compaction.index, 513.3);
  EXPECT_DOUBLE_EQ(soil.compaction.initial_density, 1200.2);
  EXPECT_EQ(soil.compaction.moisture_shift, 0);
}

// In the ranges of natural soils: a slip of a unit would be out of them.
TEST(SoilCatalogue, HoldsPlausibleSoilsOnly) {
  const Catalogue<Soil> soils = Shipped();
  for (const Soil& soil : soils.entries()) {
    SCOPED_TRACE(soil.name);
    const Compaction& c = soil.compaction;
    EXPECT_GT(c.initial_density, 800);
    EXPECT_LT(c.initial_density, 1900);
    EXPECT_GT(c.index, 100);
    EXPECT_LT(c.index, 700);
    EXPECT_GT(c.compression_time, 0.05);
    EXPECT_LT(c.compression_time, 1);
    EXPECT_LT(c.rebound_index, c.index / 5);
    const double yield = VirginStress(c, c.initial_density);
    EXPECT_GT(yield, 10e3);
    EXPECT_LT(yield, 1e6);
    EXPECT_LT(soil.shear.cohesion, 100e3);
    EXPECT_LT(soil.shear.friction_angle, 0.8);
    const double at_ten_cm =
        BearingPressure(BearingModulus(soil.bearing, 0.4), soil.bearing.n, 0.1);
    EXPECT_GT(at_ten_cm, 20e3);
    EXPECT_LT(at_ten_cm, 2e6);
  }
}

TEST(SoilCatalogue, ListsTheKnownNamesWhenOneIsUnknown) {
  Catalogue<Soil> soils = SoilCatalogue();
  soils.AddFile(WriteFile("mud.xml", SoilXml("mud")));
  soils.AddFile(WriteFile("snow.xml", SoilXml("snow")));
  try {
    soils.Find("sand");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "unknown soil \"sand\"; known are: mud, snow");
  }
}

TEST(SoilCatalogue, RefusesAFolderThatIsNotThere) {
  const std::string folder = testing::TempDir() + "no_such_folder";
  EXPECT_EQ(RefusalAt(folder, [&] { SoilCatalogue().AddFolder(folder); }),
            ": No such file or directory");
}

// Madsen (2014), equation 3.5: rho_S = S_T (S_1 - S_0).
TEST(SoilCatalogue, TurnsMoistureIntoAShiftOfTheVirginCurve) {
  Catalogue<Soil> soils = SoilCatalogue();
  soils.AddFile(
      WriteFile("wet.xml", Replaced(SoilXml("wet"), "</soil>",
                                    "<moisture slope=\"2.9\" saturation=\"0.7\" "
                                    "reference_saturation=\"0.5\" source=\"a test\"/></soil>")));
  EXPECT_NEAR(soils.Find("wet").compaction.moisture_shift, 0.58, 1e-12);
}

TEST(SoilCatalogue, RefusesMoistureThatIsNotComplete) {
  EXPECT_EQ(SoilRefusal(
                Replaced(SoilXml("wet"), "</soil>", "<moisture slope=\"2\" source=\"a\"/></soil>")),
            ":7: <soil name=\"wet\"> <moisture>: attribute saturation is missing");
}

TEST(Shown, ReadsBackAsTheSameNumber) {
  for (double value : {0.1, -3000.0, 1.0 / 3, 1e300, 1e-300}) {
    EXPECT_EQ(std::stod(Shown(value)), value);
  }
  EXPECT_EQ(Shown(-3000), "-3000");
  EXPECT_EQ(Shown(0.025), "0.025");
}

}  // namespace
}  // namespace softsoil
