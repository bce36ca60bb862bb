// What a soil file may hold besides the numbers that every soil has.
#include <gtest/gtest.h>

#include "tests/terrain/soil_file_case.h"

namespace softsoil {
namespace {

// The good file with an element more.
std::string With(const std::string& element) {
  return Replaced(SoilXml("s"), "</soil>", element + "\n</soil>");
}

// The file with <bearing> replaced.
std::string WithBearing(const std::string& attributes) {
  const std::string xml = SoilXml("s");
  const std::size_t from = xml.find("<bearing"), to = xml.find("/>", from);
  return Replaced(xml, xml.substr(from, to - from), "<bearing source=\"a test\" " + attributes);
}

Soil Read(const std::string& xml) {
  Catalogue<Soil> soils = SoilCatalogue();
  soils.AddFile(WriteFile("forms.xml", xml));
  return soils.Find("s");
}

// The refusal after the name of the soil.
std::string Refusal(const std::string& xml) {
  const std::string refusal = SoilRefusal(xml);
  const std::size_t at = refusal.find("\">");
  return at == std::string::npos ? refusal : refusal.substr(at + 2);
}

TEST(SoilFile, MayHoldBearingInTheFormOfReece) {
  const Soil soil = Read(WithBearing("form=\"reece\" k_1=\"137895\" k_2=\"678611\" n=\"0.47\""));
  EXPECT_EQ(soil.bearing.form, BearingForm::kReece);
  EXPECT_EQ(soil.bearing.k_c, 137895);
  EXPECT_EQ(soil.bearing.k_phi, 678611);
  EXPECT_EQ(Read(WithBearing("form=\"bekker\" k_c=\"1\" k_phi=\"2\" n=\"3\"")).bearing.form,
            BearingForm::kBekker);
  EXPECT_EQ(Refusal(WithBearing("form=\"reece\" k_c=\"1\" k_phi=\"2\" n=\"3\"")),
            " <bearing>: attribute k_1 is missing");
  EXPECT_EQ(Refusal(WithBearing("form=\"reece\" k_1=\"0\" k_2=\"0\" n=\"1\"")),
            ": one of k_1 and k_2 must be > 0");
  EXPECT_EQ(Refusal(WithBearing("form=\"wong\" k_1=\"0\" k_2=\"0\" n=\"1\"")),
            " <bearing>: form must be one of bekker, reece, got \"wong\"");
}

TEST(SoilFile, MayHoldAHumpedShearLaw) {
  const std::string humped =
      Replaced(SoilXml("s"), "<shear source", "<shear form=\"humped\" residual=\"0.3\" source");
  EXPECT_EQ(Read(humped).shear.form, ShearForm::kHumped);
  EXPECT_EQ(Read(humped).shear.residual, 0.3);
  EXPECT_EQ(Read(SoilXml("s")).shear.form, ShearForm::kJanosiHanamoto);
  EXPECT_EQ(Refusal(Replaced(humped, "0.3", "1.1")), " <shear>: residual must be 0 to 1, got 1.1");
  EXPECT_EQ(Refusal(Replaced(humped, " residual=\"0.3\"", "")),
            " <shear>: attribute residual is missing");
  EXPECT_EQ(Refusal(Replaced(humped, "form=\"humped\"", "form=\"janosi_hanamoto\"")),
            " <shear>: unknown attribute residual");
}

TEST(SoilFile, MayHoldSlipSinkage) {
  EXPECT_EQ(Read(SoilXml("s")).slip_sinkage, 0);
  const std::string sinks =
      Replaced(SoilXml("s"), "<shear source", "<shear slip_sinkage=\"0.3\" source");
  EXPECT_EQ(Read(sinks).slip_sinkage, 0.3);
  EXPECT_EQ(Refusal(Replaced(sinks, "0.3", "-0.1")),
            " <shear>: slip_sinkage must be >= 0, got -0.1");
  EXPECT_EQ(Refusal(Replaced(sinks, "0.3", "11")), ": slip_sinkage must be 0 to 10, got 11");
}

TEST(SoilFile, MaySayThatTheGroundSpringsBack) {
  const std::string xml = With("<unloading k_0=\"0\" A_u=\"503e6\" source=\"a test\"/>");
  EXPECT_EQ(Read(xml).unloading.k_0, 0);
  EXPECT_EQ(Read(xml).unloading.A_u, 503e6);
  EXPECT_TRUE(Read(SoilXml("s")).unloading.IsRigid());
  EXPECT_EQ(Refusal(Replaced(xml, "503e6", "0")), ": one of k_0 and A_u must be > 0");
  EXPECT_EQ(Refusal(Replaced(xml, "503e6", "-1")), " <unloading>: A_u must be >= 0 Pa/m^2, got -1");
}

TEST(SoilFile, MayHoldThePlaceOfTheGreatestStress) {
  const std::string xml = With("<max_stress c_1=\"0.43\" c_2=\"0.32\" source=\"a test\"/>");
  EXPECT_EQ(Read(xml).max_stress->c_1, 0.43);
  EXPECT_EQ(Read(xml).max_stress->c_2, 0.32);
  EXPECT_FALSE(Read(SoilXml("s")).max_stress.has_value());
}

TEST(SoilFile, MovesTheVirginCurveByMoisture) {
  const std::string xml =
      With("<moisture slope=\"530\" saturation=\"1\" reference_saturation=\"0.4\" source=\"x\"/>");
  EXPECT_DOUBLE_EQ(Read(Replaced(xml, "530", "-0.5")).compaction.moisture_shift, -0.3);
  EXPECT_EQ(Refusal(Replaced(xml, "\"1\"", "\"1.01\"")),
            " <moisture>: saturation must be 0 to 1, got 1.01");
  EXPECT_EQ(Refusal(Replaced(xml, "\"0.4\"", "\"40\"")),
            " <moisture>: reference_saturation must be 0 to 1, got 40");
}

TEST(SoilFile, MayHoldLayersOfDensity) {
  const Soil soil =
      Read(With("<layers top=\"0.15 0.3\" initial_density=\"1350 1500\" source=\"a test\"/>"));
  EXPECT_EQ(InitialDensity(soil, 0.1), soil.compaction.initial_density);
  EXPECT_EQ(InitialDensity(soil, 0.15), 1350);
  EXPECT_EQ(InitialDensity(soil, 0.29), 1350);
  EXPECT_EQ(InitialDensity(soil, 5), 1500);
}

TEST(SoilFile, RefusesLayersThatMakeNoProfile) {
  const auto layers = [](const std::string& tops, const std::string& densities) {
    return Refusal(With("<layers top=\"" + tops + "\" initial_density=\"" + densities +
                        "\" source=\"a test\"/>"));
  };
  EXPECT_EQ(layers("0.1 0.2", "1300"),
            ": top and initial_density of <layers> must be as many numbers, got 2 and 1");
  EXPECT_EQ(layers("0.2 0.1", "1300 1400"), ": top of <layers> must rise, got 0.1 m after 0.2 m");
  EXPECT_EQ(layers("0.2 deep", "1300 1400"),
            " <layers>: top must be a finite number m, got \"deep\"");
  EXPECT_EQ(layers("0", "1300"), " <layers>: top must be > 0 m, got 0");
  EXPECT_EQ(layers(" ", "1300"), " <layers>: top must not be empty");
  // A soil whose virgin curve has 100 Pa above the density of the layer.
  const std::string loose =
      Replaced(With("<layers top=\"0.2\" initial_density=\"4\" source=\"a test\"/>"),
               "reference_density=\"3.8\" reference_stress=\"390000\" initial_density=\"4\"",
               "reference_density=\"1000\" reference_stress=\"390000\" initial_density=\"1000\"");
  EXPECT_NE(Refusal(loose).find("where the virgin curve has 100 Pa, got 4"), std::string::npos);
}

}  // namespace
}  // namespace softsoil
