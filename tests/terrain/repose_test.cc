// How steep soil stands.
#include "terrain/repose.h"

#include <gtest/gtest.h>

#include "tests/terrain/soil_file_case.h"
#include "tests/terrain/test_soil.h"

namespace softsoil {
namespace {

constexpr double kGamma = 15e3;  // [N/m^3]
const Shear kLoam = {5e3, 25 / kDegrees, 0.01};

TEST(CriticalHeight, OfAVerticalCutIsThatOfTerzaghi) {
  const double printed = 4 * 5e3 / kGamma * std::tan(kPi / 4 + kLoam.friction_angle / 2);
  EXPECT_NEAR(CriticalHeight(kLoam, kGamma, kPi / 2), printed, 1e-12);
}

TEST(CriticalHeight, HasNoLimitUpToTheFrictionAngle) {
  EXPECT_EQ(CriticalHeight(kLoam, kGamma, kLoam.friction_angle),
            std::numeric_limits<double>::infinity());
  EXPECT_EQ(CriticalHeight({0, 0.5, 0.01}, kGamma, 0.6), 0);
}

TEST(CriticalHeight, FallsAsTheSlopeSteepens) {
  double last = 1e9;
  for (double beta = 0.5; beta < kPi / 2; beta += 0.1) {
    const double height = CriticalHeight(kLoam, kGamma, beta);
    EXPECT_LT(height, last) << beta;
    last = height;
  }
}

TEST(SteepestHeap, IsTheFrictionAngleWithoutCohesion) {
  EXPECT_NEAR(SteepestHeap({0, 0.6, 0.01}, kGamma, 1), 0.6, 1e-9);
}

TEST(SteepestHeap, StandsJustSoHigh) {
  const Shear sand = {1300, 31.1 / kDegrees, 0.01};
  const double angle = SteepestHeap(sand, kGamma, 1);
  EXPECT_GT(angle, sand.friction_angle);
  EXPECT_LT(angle, kPi / 2);
  EXPECT_NEAR(CriticalHeight(sand, kGamma, angle), 1, 1e-6);
}

TEST(AngleOfRepose, IsTheFrictionAngleUnlessGiven) {
  Soil soil = LooseSoil();
  EXPECT_EQ(AngleOfRepose(soil), soil.shear.friction_angle);
  soil.shear.friction_angle = 0;
  EXPECT_EQ(AngleOfRepose(soil), kLeastRepose);
  soil.angle_of_repose = 0.7;
  EXPECT_EQ(AngleOfRepose(soil), 0.7);
}

// Dry sand of 1600 kg/m^3 that stands at its friction angle, 30 degrees, and no steeper.
std::string Sand(const std::string& angle) {
  std::string xml = SoilXml("sand");
  xml = Replaced(xml, "cohesion=\"340000\"", "cohesion=\"0\"");
  xml = Replaced(xml, "friction_angle_deg=\"3.5\"",
                 "friction_angle_deg=\"30\" angle_of_repose_deg=\"" + angle + "\"");
  return xml;
}

TEST(AngleOfRepose, IsReadInDegrees) {
  Catalogue<Soil> soils = SoilCatalogue();
  soils.AddFile(WriteFile("soil.xml", Sand("25")));
  EXPECT_NEAR(AngleOfRepose(soils.Find("sand")), 25 / kDegrees, 1e-12);
}

TEST(AngleOfRepose, IsRefusedAboveFrictionAndCohesion) {
  EXPECT_EQ(SoilRefusal(Sand("30")), "");
  EXPECT_EQ(SoilRefusal(Sand("31")),
            ":2: <soil name=\"sand\">: angle_of_repose_deg must be 5 to 30 deg, at which friction "
            "and cohesion hold a heap 1 m high, got 31");
  EXPECT_EQ(SoilRefusal(Replaced(Sand("60"), "cohesion=\"0\"", "cohesion=\"90000\"")), "");
  EXPECT_NE(SoilRefusal(Sand("4")), "");
  EXPECT_NE(SoilRefusal(Sand("steep")), "");
}

}  // namespace
}  // namespace softsoil
