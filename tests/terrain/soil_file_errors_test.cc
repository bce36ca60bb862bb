// Bad soil files are refused in one sentence: file, line, name, rule, value.
#include <gtest/gtest.h>

#include <string>

#include "tests/terrain/soil_file_case.h"

namespace softsoil {
namespace {

const std::string kGood = SoilXml("mud");

// The sentence when `from` in a good file becomes `to`.
std::string Refusal(const std::string& from, const std::string& to) {
  return SoilRefusal(Replaced(kGood, from, to));
}

TEST(SoilFile, IsTakenWhenGood) { EXPECT_EQ(SoilRefusal(kGood), ""); }

TEST(SoilFile, RefusesANegativeValue) {
  EXPECT_EQ(Refusal("cohesion=\"340000\"", "cohesion=\"-3000\""),
            ":4: <soil name=\"mud\"> <shear>: cohesion must be >= 0 Pa, got -3000");
}

TEST(SoilFile, RefusesWhatIsNoNumber) {
  for (const std::string text : {"forty", "0x10", "nan", "NaN", "inf", "-inf", "infinity", "1e999",
                                 "", " ", "1 2", "3,5", "7100Pa"}) {
    EXPECT_EQ(Refusal("cohesion=\"340000\"", "cohesion=\"" + text + "\""),
              ":4: <soil name=\"mud\"> <shear>: cohesion must be a finite number Pa, got \"" +
                  text + "\"");
  }
}

TEST(SoilFile, RefusesAMissingElement) {
  EXPECT_EQ(SoilRefusal("<soils>\n\n<soil name=\"mud\"/></soils>"),
            ":3: <soil name=\"mud\">: element <bearing> is missing");
}

TEST(SoilFile, RefusesAnUnknownElement) {
  EXPECT_EQ(Refusal("</soil>", "<colour r=\"1\" source=\"x\"/></soil>"),
            ":2: <soil name=\"mud\">: unknown element <colour>");
}

TEST(SoilFile, RefusesADoubledElement) {
  EXPECT_EQ(Refusal("</soil>", "<stress source=\"x\" concentration_factor=\"5\"/>\n</soil>"),
            ":7: <soil name=\"mud\"> <stress>: stands here a second time");
}

TEST(SoilFile, RefusesAnUnknownAttribute) {
  EXPECT_EQ(Refusal("<shear ", "<shear colesion=\"1\" "),
            ":4: <soil name=\"mud\"> <shear>: unknown attribute colesion");
  EXPECT_EQ(Refusal("<soil name=\"mud\"", "<soil name=\"mud\" colour=\"red\""),
            ":2: <soil name=\"mud\">: unknown attribute colour");
  EXPECT_EQ(Refusal("<soils>", "<soils version=\"2\">"), ":1: <soils> must hold <soil> alone");
}

TEST(SoilFile, RefusesADoubledAttribute) {
  EXPECT_EQ(Refusal("<shear ", "<shear cohesion=\"1\" "),
            ":4: an attribute of this element is malformed or stands here twice");
}

TEST(SoilFile, RefusesAMissingSource) {
  const std::string rule =
      ":3: <soil name=\"mud\"> <bearing>: attribute source is missing: say where the numbers come "
      "from";
  EXPECT_EQ(Refusal(" source=\"a test\"", ""), rule);
  EXPECT_EQ(Refusal(" source=\"a test\"", " source=\"\""), rule);
}

TEST(SoilFile, RefusesAMissingName) {
  EXPECT_EQ(Refusal(" name=\"mud\"", ""), ":2: <soil name=\"\">: attribute name is missing");
  EXPECT_EQ(Refusal(" name=\"mud\"", " name=\"\""),
            ":2: <soil name=\"\">: attribute name is missing");
}

TEST(SoilFile, RefusesWhatIsBelowOrBesideItsElements) {
  EXPECT_EQ(Refusal("\"/>\n<shear", "\"><deep/></bearing>\n<shear"),
            ":3: <soil name=\"mud\"> <bearing>: must hold attributes alone");
  EXPECT_EQ(Refusal("\"/>\n<shear", "\">soft</bearing>\n<shear"),
            ":3: <soil name=\"mud\"> <bearing>: must hold attributes alone");
  EXPECT_EQ(Refusal("</soil>", "soft</soil>"),
            ":2: <soil name=\"mud\">: must hold elements alone, no text");
  EXPECT_EQ(Refusal("</soils>", "soft</soils>"), ":1: <soils> must hold <soil> alone");
  EXPECT_EQ(Refusal("</soils>\n", "</soils>\n<soils/>"),
            ":9: expected one root alone, got <soils>");
}

TEST(SoilFile, MayHoldComments) {
  EXPECT_EQ(Refusal("<bearing", "<!-- why --><bearing"), "");
  EXPECT_EQ(Refusal("</soils>", "<!-- why --></soils>"), "");
}

TEST(SoilFile, RefusesOtherEntriesAndRoots) {
  EXPECT_EQ(Refusal("</soils>", "<tire/></soils>"), ":8: expected <soil>, got <tire>");
  EXPECT_EQ(SoilRefusal("\n<tires/>"), ":2: expected the root <soils>, got <tires>");
}

TEST(SoilFile, RefusesMalformedXml) {
  EXPECT_EQ(SoilRefusal("<soils>\n<soil name=\"mud\">\n</soils>"),
            ":2: this element is not closed");
  EXPECT_EQ(Refusal("<shear source=\"a test\"", "<shear source=\"a test"),
            ":4: is not well-formed XML");
  EXPECT_EQ(SoilRefusal("soft"), ":1: is not well-formed XML");
}

TEST(SoilFile, RefusesAnEmptyFile) {
  EXPECT_EQ(SoilRefusal(""), ": holds no element");
  EXPECT_EQ(SoilRefusal("<!-- nothing -->"), ": holds no element");
}

TEST(SoilFile, RefusesWhatIsNoFile) {
  const std::string folder = testing::TempDir();
  EXPECT_EQ(RefusalAt(folder, [&] { SoilCatalogue().AddFile(folder); }),
            ": cannot be read; is it a folder?");
  const std::string missing = folder + "no_such_soil.xml";
  EXPECT_EQ(RefusalAt(missing, [&] { SoilCatalogue().AddFile(missing); }),
            ": there is no such file");
}

TEST(SoilFile, RefusesANameThatIsTakenInTheSameFile) {
  const std::string second = kGood.substr(kGood.find("<soil "));
  EXPECT_EQ(Refusal("</soils>\n", second), ":8: <soil name=\"mud\">: this name is taken already");
}

TEST(SoilFile, RefusesANameThatIsTakenInAnotherFile) {
  Catalogue<Soil> soils = SoilCatalogue();
  soils.AddFile(WriteFile("first.xml", kGood));
  const std::string second = WriteFile("second.xml", kGood);
  EXPECT_EQ(RefusalAt(second, [&] { soils.AddFile(second); }),
            ":2: <soil name=\"mud\">: this name is taken already");
}

// At 1e-20 Pa and less every load would compact the soil as far as the grid reaches.
TEST(SoilFile, RefusesSoilThatYieldsUnderNothing) {
  const std::string refusal = Refusal("reference_density=\"3.8\"", "reference_density=\"1000\"");
  EXPECT_EQ(refusal.substr(0, refusal.find(">= ") + 3),
            ":2: <soil name=\"mud\">: initial_density must be >= ");
  EXPECT_NE(refusal.find(" kg/m^3, where the virgin curve has 100 Pa, got 4"), std::string::npos)
      << refusal;
}

}  // namespace
}  // namespace softsoil
