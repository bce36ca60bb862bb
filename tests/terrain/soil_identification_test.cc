#include "terrain/soil_identification.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "terrain/constants.h"
#include "terrain/input_error.h"
#include "terrain/pedotransfer.h"
#include "tests/terrain/test_soil.h"

namespace softsoil {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::ThrowsMessage;

SoilEvidence OfClass(const char* name) {
  SoilEvidence evidence;
  evidence.uscs = &FindUscsSoil(name);
  evidence.composition = evidence.uscs->composition;
  return evidence;
}

SoilEvidence ClassAndLike(const char* name) {
  SoilEvidence evidence = OfClass(name);
  evidence.like = LooseSoil();
  return evidence;
}

Tested<ShearFit> SomeShearTest() {
  ShearFit fit{};
  fit.cohesion = {7100, 100, 200};
  fit.friction_angle = {0.37, 0.01, 0.02};
  fit.modulus = {0.0106, 0.001, 0.002};
  return {fit, "shear.csv", "shear.csv: a test"};
}

Tested<BearingFit> SomePlateTest(ModuliFrom basis) {
  BearingFit fit{};
  fit.basis = basis;
  fit.cohesive = {basis == ModuliFrom::kPlates ? 5000.0 : 0.0, 10, 20};
  fit.frictional = {1e6, 1e4, 2e4};
  fit.exponent = {0.9, 0.01, 0.02};
  fit.widths = {0.3};
  return {fit, "plate.csv", "plate.csv: a test"};
}

std::optional<Finding> Find(const IdentifiedSoil& soil, const std::string& parameter) {
  const auto found = std::find_if(soil.findings.begin(), soil.findings.end(),
                                  [&](const Finding& f) { return f.parameter == parameter; });
  return found == soil.findings.end() ? std::nullopt : std::optional<Finding>(*found);
}

TEST(Identify, OfAClassGivesTheShearAndTheVirginCurveOfTheThesis) {
  const IdentifiedSoil found = Identify(OfClass("CL"));
  const Soil& soil = found.entry.soil;
  EXPECT_NEAR(soil.shear.cohesion, 26910, 5);
  EXPECT_NEAR(soil.shear.friction_angle * 180 / kPi, 16.60, 0.005);
  EXPECT_NEAR(soil.shear.modulus, 0.0125, 5e-5);
  EXPECT_NEAR(soil.compaction.index, 513.3, 0.05);
  EXPECT_NEAR(soil.compaction.rebound_index, 20.28, 0.005);
  EXPECT_THAT(found.missing, ElementsAre("bearing", "compaction", "stress"));
  EXPECT_EQ(Find(found, "clay index")->how, "printed");
}

TEST(Identify, CompletesASoilByAnotherAndSaysSo) {
  const IdentifiedSoil found = Identify(ClassAndLike("CL"));
  EXPECT_THAT(found.missing, IsEmpty());
  EXPECT_EQ(found.entry.soil.bearing.k_phi, LooseSoil().bearing.k_phi);
  EXPECT_EQ(found.entry.soil.compaction.compression_time, 0.2);
  EXPECT_EQ(found.entry.source.at("bearing"), "not identified: as of loose");
  EXPECT_THAT(found.entry.source.at("compaction"), HasSubstr("times as of loose"));
  EXPECT_THAT(found.entry.source.at("shear"), HasSubstr("USCS CL"));
  EXPECT_EQ(Find(found, "bearing k_phi")->how, "as of another");
}

// Madsen (2014), 6.1.1: the computed values are "not used when experimental values from shear tests
// are available".
TEST(Identify, TrustsAMeasuredShearMoreThanARelation) {
  SoilEvidence evidence = ClassAndLike("CL");
  evidence.shear = SomeShearTest();
  const IdentifiedSoil found = Identify(evidence);
  EXPECT_EQ(found.entry.soil.shear.cohesion, 7100);
  EXPECT_DOUBLE_EQ(found.entry.soil.shear.friction_angle, 0.37);
  EXPECT_EQ(found.entry.source.at("shear"), "least squares of shear tests, shear.csv: a test");
  EXPECT_NEAR(Find(found, "shear friction_angle_deg")->confidence, 0.02 * 180 / kPi, 1e-9);
}

// Thesis 6.1.1: the tilled loam, CL, has 1200.2 kg/m^3 and yields at about 96 kPa.
TEST(Identify, PutsAMeasuredDensityOnTheVirginCurve) {
  SoilEvidence evidence = ClassAndLike("CL");
  evidence.bulk_density = 1200.2;
  const IdentifiedSoil found = Identify(evidence);
  EXPECT_EQ(found.entry.soil.compaction.initial_density, 1200.2);
  EXPECT_NEAR(Find(found, "preconsolidation stress")->value, 95.93e3, 200);
  EXPECT_THAT(found.entry.source.at("compaction"), HasSubstr("initial density measured"));
}

TEST(Identify, TakesASoilOfUnknownDensityAsNeverLoadedBeyondTheReference) {
  const IdentifiedSoil found = Identify(ClassAndLike("CL"));
  EXPECT_NEAR(Find(found, "preconsolidation stress")->value, 98e3, 1e-6);
  EXPECT_EQ(Find(found, "compaction initial_density")->how, "assumed");
}

TEST(Identify, MovesTheVirginCurveByMoisture) {
  SoilEvidence evidence = ClassAndLike("CH");
  evidence.saturation = Saturation{0.6, 0.4};
  const IdentifiedSoil found = Identify(evidence);
  EXPECT_NEAR(found.entry.soil.compaction.moisture_shift, 0.2 * MoistureSlope(13.3), 1e-9);
  EXPECT_EQ(found.entry.moisture->saturation, 0.6);
  EXPECT_NEAR(Find(found, "preconsolidation stress")->value, 98e3, 1e-6);
  evidence.saturation = Saturation{1.2, 0.4};
  EXPECT_THAT([&] { Identify(evidence); },
              ThrowsMessage<InputError>("a saturation must be 0 to 1, got 1.2"));
  evidence = ClassAndLike("SW");
  evidence.saturation = Saturation{0.6, 0.4};
  EXPECT_THAT([&] { Identify(evidence); }, ThrowsMessage<InputError>(HasSubstr("coarse soils")));
}

TEST(Identify, KeepsTheMoistureShiftOfAnotherSoilInItsDensity) {
  SoilEvidence evidence;
  evidence.like = LooseSoil();
  evidence.like->compaction.moisture_shift = 30;
  const IdentifiedSoil found = Identify(evidence);
  const Compaction& soil = found.entry.soil.compaction;
  EXPECT_EQ(soil.moisture_shift, 0);
  EXPECT_DOUBLE_EQ(VirginStress(soil, 1250), VirginStress(evidence.like->compaction, 1250));
}

TEST(Identify, NeedsMoreThanADensity) {
  SoilEvidence evidence;
  evidence.bulk_density = 1400;
  EXPECT_THAT([&] { Identify(evidence); },
              ThrowsMessage<InputError>(HasSubstr("a bulk density alone gives no virgin curve")));
  evidence.like = LooseSoil();
  EXPECT_EQ(Identify(evidence).entry.soil.compaction.initial_density, 1400);
  evidence.bulk_density = 3000;
  EXPECT_THAT([&] { Identify(evidence); }, ThrowsMessage<InputError>(HasSubstr(
                                               "to below 2650 kg/m^3, the density of quartz, got "
                                               "3000 kg/m^3")));
  evidence = {};
  evidence.saturation = Saturation{0.6, 0.4};
  EXPECT_THAT([&] { Identify(evidence); },
              ThrowsMessage<InputError>(HasSubstr("needs the composition")));
}

TEST(Identify, TakesNoCohesiveModulusOfOnePlateForGranted) {
  SoilEvidence evidence = ClassAndLike("CL");
  evidence.bearing = SomePlateTest(ModuliFrom::kPlatesOfOneWidth);
  const IdentifiedSoil open = Identify(evidence);
  EXPECT_THAT(open.missing, ElementsAre("bearing"));
  EXPECT_EQ(Find(open, "bearing k_e")->value, 1e6);
  evidence.is_frictional = true;
  const IdentifiedSoil said = Identify(evidence);
  EXPECT_THAT(said.missing, IsEmpty());
  EXPECT_EQ(said.entry.soil.bearing.k_c, 0);
  EXPECT_EQ(said.entry.soil.bearing.k_phi, 1e6);
  EXPECT_THAT(Find(said, "bearing k_phi")->warning, HasSubstr("holds for that width"));
}

TEST(Identify, TellsOfABoundThatDecidedInPlaceOfTheData) {
  SoilEvidence evidence = ClassAndLike("CL");
  evidence.bearing = SomePlateTest(ModuliFrom::kNoCohesive);
  evidence.bearing->fit.free_value = -3200;
  evidence.shear = SomeShearTest();
  evidence.shear->fit.bound = StrengthBound::kNoCohesion;
  evidence.shear->fit.free_value = -500;
  const IdentifiedSoil found = Identify(evidence);
  EXPECT_THAT(Find(found, "bearing k_c")->warning, HasSubstr("the readings ask for -3200"));
  EXPECT_THAT(Find(found, "shear cohesion")->warning, HasSubstr("the readings ask for -500"));
  evidence.bearing = SomePlateTest(ModuliFrom::kNoFrictional);
  evidence.bearing->fit.form = BearingForm::kReece;
  evidence.bearing->fit.cohesive = {50e3, 100, 200};
  evidence.bearing->fit.frictional = HeldAt(0);
  evidence.bearing->fit.free_value = -4000;
  const IdentifiedSoil clay = Identify(evidence);
  EXPECT_EQ(Find(clay, "bearing k_1")->value, 50e3);
  EXPECT_EQ(Find(clay, "bearing k_2")->value, 0);
  EXPECT_THAT(Find(clay, "bearing k_2")->warning, HasSubstr("the readings ask for -4000"));
  EXPECT_THAT(clay.undetermined, IsEmpty());
}

TEST(Identify, WarnsOfAParameterThatTheReadingsHardlyDetermine) {
  SoilEvidence evidence = ClassAndLike("CL");
  evidence.shear = SomeShearTest();
  EXPECT_EQ(Find(Identify(evidence), "shear cohesion")->warning, "");
  evidence.shear->fit.cohesion.confidence = 8000;
  EXPECT_EQ(Find(Identify(evidence), "shear cohesion")->warning,
            "the readings hardly determine it");
}

TEST(Identify, NamesTheParametersThatMayNotBeZeroButMightBe) {
  SoilEvidence evidence = ClassAndLike("CL");
  evidence.bearing = SomePlateTest(ModuliFrom::kPlates);
  BearingFit& fit = evidence.bearing->fit;
  fit.cohesive.confidence = 6000;  // of 5000: cohesion may be none
  EXPECT_THAT(Identify(evidence).undetermined, IsEmpty());
  fit.frictional.confidence = 2e6;
  fit.exponent.confidence = 1;
  EXPECT_THAT(Identify(evidence).undetermined, ElementsAre("bearing k_phi", "bearing n"));
  fit.exponent.confidence = 0.02;
  fit.form = BearingForm::kReece;
  EXPECT_THAT(Identify(evidence).undetermined, ElementsAre("bearing k_1", "bearing k_2"));
  fit.cohesive.confidence = 20;
  EXPECT_THAT(Identify(evidence).undetermined, IsEmpty());
}

// A soil with everything that a soil may have besides.
Soil FullSoil() {
  Soil soil = LooseSoil();
  soil.unloading = {1.5e6, 2.5e8};
  soil.shear.form = ShearForm::kHumped;
  soil.shear.residual = 0.3;
  soil.layers = {{0.15, 1350}, {0.3, 1500}};
  soil.max_stress = MaxStress{0.43, 0.32};
  return soil;
}

TEST(Identify, ReportsAllThatTheEntryHasOfAnotherSoil) {
  SoilEvidence evidence;
  evidence.like = FullSoil();
  const IdentifiedSoil found = Identify(evidence);
  const std::pair<const char*, double> rows[] = {{"shear residual", 0.3},
                                                 {"unloading k_0", 1.5e6},
                                                 {"unloading A_u", 2.5e8},
                                                 {"layers initial_density below 0.15 m", 1350},
                                                 {"layers initial_density below 0.3 m", 1500},
                                                 {"max_stress c_1", 0.43},
                                                 {"max_stress c_2", 0.32}};
  for (const auto& [parameter, value] : rows) {
    const auto finding = Find(found, parameter);
    ASSERT_TRUE(finding) << parameter;
    EXPECT_EQ(finding->value, value) << parameter;
    EXPECT_EQ(finding->how, "as of another") << parameter;
    EXPECT_EQ(finding->made_from, "loose") << parameter;
  }
  EXPECT_EQ(found.entry.source.at("max_stress"), "not identified: as of loose");
}

TEST(Identify, ReportsNothingOfAnotherSoilThatTheEntryHasNot) {
  SoilEvidence evidence = ClassAndLike("CL");
  for (const char* parameter : {"unloading k_0", "max_stress c_1", "shear residual"}) {
    EXPECT_FALSE(Find(Identify(evidence), parameter)) << parameter;
  }
  evidence.like = FullSoil();  // whose hump and layers measurements and relations replace
  EXPECT_FALSE(Find(Identify(evidence), "shear residual"));
  EXPECT_FALSE(Find(Identify(evidence), "layers initial_density below 0.15 m"));
  EXPECT_TRUE(Find(Identify(evidence), "max_stress c_1"));
}

TEST(Identify, WithoutCompositionAndDensityIsAsDenseAsTheOtherSoil) {
  SoilEvidence evidence;
  evidence.like = LooseSoil();
  evidence.like->compaction.initial_density = 1300;
  const IdentifiedSoil found = Identify(evidence);
  EXPECT_EQ(found.entry.soil.compaction.initial_density, 1300);
  EXPECT_GT(Find(found, "preconsolidation stress")->value, 1.5 * 96e3);
}

}  // namespace
}  // namespace softsoil
