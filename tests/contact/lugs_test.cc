// Lugs as the tire's file describes them, and where they stand on the tread.
#include "contact/lugs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "contact/tire_nodes.h"
#include "terrain/constants.h"
#include "tests/contact/samples.h"
#include "tests/terrain/catalogue_case.h"

namespace softsoil {
namespace {

constexpr double kRadius = 0.91;  // [m]

std::string FileWith(const std::string& lugs) {
  return R"(<tires>
<tire name="fat">
<shape type="torus" radius="0.91" crown_radius="0.661" width="0.467" source="a test"/>
<lugs )" +
         lugs + R"( source="a test"/>
<spring root="346900" damping="8900" source="a test"/>
<friction coefficient="0.65" source="a test"/>
</tire>
</tires>
)";
}

Lugs Read(const std::string& lugs) {
  Catalogue<Tire> tires = TireCatalogue();
  tires.AddText(FileWith(lugs), "tire.xml");
  return tires.Find("fat").shape.lugs;
}

std::string Refusal(const std::string& lugs) {
  return RefusalAt("tire.xml", [&] { Read(lugs); });
}

const std::string kEntry = ":2: <tire name=\"fat\">: ";
const std::string kLugs = ":4: <tire name=\"fat\"> <lugs>: ";

TEST(Lugs, FollowFromAnyTwoOfWidthPitchAndVoidShare) {
  const double circumference = 2 * kPi * kRadius, pitch = circumference / 22;
  const double width = 0.25 * pitch * std::cos(kPi / 4);
  const std::string rest = "height=\"0.038\" angle_deg=\"45\" ";
  for (const std::string& two :
       {std::string("count=\"22\" void_share=\"0.75\""),
        "pitch=\"" + std::to_string(pitch) + "\" void_share=\"0.75\"",
        "count=\"22\" width=\"" + std::to_string(width) + "\"",
        "width=\"" + std::to_string(width) + "\" void_share=\"0.75\"",
        "count=\"22\" void_share=\"0.75\" width=\"" + std::to_string(width) + "\""}) {
    SCOPED_TRACE(two);
    const Lugs lugs = Read(rest + two);
    EXPECT_EQ(lugs.height, 0.038);
    EXPECT_EQ(lugs.count, 22);
    EXPECT_NEAR(lugs.angle, kPi / 4, 1e-12);
    EXPECT_NEAR(lugs.void_share, 0.75, 1e-4);
    EXPECT_NEAR(LugWidth(lugs, kRadius), width, 1e-5);
    EXPECT_NEAR(LugGap(lugs, kRadius), 0.75 * pitch, 1e-5);
  }
}

TEST(Lugs, AreRefusedIfWiderThanTheirPitch) {
  EXPECT_EQ(Refusal("height=\"0.04\" width=\"0.3\" pitch=\"0.25\""),
            kEntry + "width / cos(angle) of a lug must be < the pitch, 0.25 m, got 0.3");
}

TEST(Lugs, AreRefusedIfWidthAndVoidShareContradictEachOther) {
  EXPECT_EQ(Refusal("height=\"0.04\" width=\"0.1\" pitch=\"0.25\" void_share=\"0.7\""),
            kEntry + "void_share must be 1 - width / (cos(angle) pitch) = 0.6, got 0.7");
}

TEST(Lugs, AreRefusedIfHigherThanTheTire) {
  const std::string refusal = Refusal("height=\"0.9\" count=\"20\" void_share=\"0.7\"");
  const std::string rule = kEntry + "height of the lugs must be < 0.8673";
  EXPECT_EQ(refusal.substr(0, rule.size()), rule);
}

TEST(Lugs, AreRefusedIfTheyAreTooFewNumbersOrTooMany) {
  EXPECT_EQ(Refusal("height=\"0.04\" count=\"20\""),
            kEntry + "<lugs> must have two of: width, void_share, and pitch or count");
  EXPECT_EQ(Refusal("height=\"0.04\" count=\"20\" pitch=\"0.2\" void_share=\"0.7\""),
            kEntry + "<lugs> must have a pitch or a count, not both");
  EXPECT_EQ(Refusal("height=\"0.04\" count=\"20.5\" void_share=\"0.7\""),
            kEntry + "count must be a whole number, got 20.5");
  EXPECT_EQ(Refusal("height=\"0.04\" count=\"20\" void_share=\"1\""),
            kEntry + "void_share must be > 0 and < 1, got 1");
  EXPECT_EQ(Refusal("height=\"0\" count=\"20\" void_share=\"0.7\""),
            kLugs + "height must be > 0 m, got 0");
  EXPECT_EQ(Refusal("height=\"0.04\" count=\"20\" void_share=\"0.7\" tilt=\"1\""),
            kLugs + "unknown attribute tilt");
  EXPECT_EQ(Refusal("height=\"0.04\" pitch=\"9\" void_share=\"0.7\"").substr(0, 60),
            (kEntry + "pitch must be <= the circumference, 5.71").substr(0, 60));
  EXPECT_EQ(Refusal("height=\"0.04\" count=\"5000\" void_share=\"0.7\"").substr(0, 60),
            (kEntry + "lugs and gaps must be >= 0.001 m along").substr(0, 60));
}

TEST(Lugs, CoverTheirShareOfTheTread) {
  const Lugs lugs{0.04, 22, kPi / 4, 0.75, 0.5};
  for (const double y : {-0.2, 0.0, 0.13}) {
    int on_lug = 0;
    for (int i = 0; i < 100000; ++i) on_lug += IsLug(lugs, kRadius, 2 * kPi * i / 100000, y);
    EXPECT_NEAR(on_lug / 1e5, 0.25, 1e-3);
  }
}

TEST(Lugs, OfBothHalvesAreMirrored) {
  const Lugs lugs{0.04, 22, kPi / 4, 0.75, 0};
  for (int i = 0; i < 1000; ++i) {
    EXPECT_EQ(IsLug(lugs, kRadius, 0.01 * i, 0.11), IsLug(lugs, kRadius, 0.01 * i, -0.11));
  }
}

// 45 degrees: a bar is as much further around the wheel as it is further across.
TEST(Lugs, LeanByTheirAngle) {
  const Lugs lugs{0.04, 22, kPi / 4, 0.75, 0};
  for (int i = 0; i < 1000; ++i) {
    const double theta = 0.00317 * i;
    EXPECT_EQ(IsLug(lugs, kRadius, theta, 0), IsLug(lugs, kRadius, theta + 0.2 / kRadius, 0.2));
  }
}

TEST(LuggedNodes, StandWhereTheLugsAreAndForTheirArea) {
  TireShape shape = AgriculturalTire().shape;
  const double smooth = [&] {
    double sum = 0;
    for (const double area : MakeTireNodes(shape, 0.05).area) sum += area;
    return sum;
  }();
  shape.lugs = {0.038, 22, kPi / 4, 0.75, 0.5};
  for (const double spacing : {0.02, 0.05, 0.3}) {
    const TireNodes nodes = MakeTireNodes(shape, spacing);
    double lug_share = 0, sum = 0;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const Eigen::Vector3d& p = nodes.position_t[i];
      EXPECT_EQ(nodes.on_lug[i], IsLug(shape.lugs, kRadius, std::atan2(p.x(), -p.z()), p.y()));
      sum += nodes.area[i];
      if (nodes.on_lug[i]) lug_share += nodes.area[i];
    }
    EXPECT_NEAR(lug_share / sum, 0.25, 1e-12);
    EXPECT_NEAR(sum / smooth, 1, 0.02);
  }
}

}  // namespace
}  // namespace softsoil
