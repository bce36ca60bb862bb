// Inflation pressure as a setting of the tire.
#include "contact/tire_family.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "contact/flat_plate.h"
#include "tests/terrain/catalogue_case.h"

namespace softsoil {
namespace {

using testing::HasSubstr;

Catalogue<Tire> Shipped() {
  Catalogue<Tire> tires = TireCatalogue();
  tires.AddFolder(SOFTSOIL_SOURCE_DIR "/models/tires");
  return tires;
}

Tire Found(const std::string& name) { return FindTire(Shipped(), name); }

double LoadOf(const std::string& name) { return FlatPlateLoad(Found(name), 0.08, 0.005); }

std::string RefusalOf(const std::string& name) {
  return RefusalAt("", [&] { Found(name); });
}

struct Tested {
  const char *low, *high;                 // members
  const char *at_low, *middle, *at_high;  // of the family
};
constexpr Tested kTested[] = {
    {"18.4R38_85kPa", "18.4R38_125kPa", "18.4R38@85kPa", "18.4R38@1.05bar", "18.4R38@125000Pa"},
    {"18.4R38_85kPa_linear", "18.4R38_125kPa_linear", "18.4R38_linear@85kPa",
     "18.4R38_linear@105kPa", "18.4R38_linear@125kPa"},
    {"37x12.5R16.5_15psi", "37x12.5R16.5_35psi", "37x12.5R16.5@15psi", "37x12.5R16.5@25psi",
     "37x12.5R16.5@35psi"}};

TEST(InflationPressure, GivesTheEntryAtATestedPressure) {
  for (const Tested& tested : kTested) {
    for (const auto& [member, name] :
         {std::pair(tested.low, tested.at_low), std::pair(tested.high, tested.at_high)}) {
      const Tire entry = Found(member), tire = Found(name);
      EXPECT_EQ(tire.name, name);
      EXPECT_EQ(tire.spring.linear, entry.spring.linear);
      EXPECT_EQ(tire.spring.root, entry.spring.root);
      EXPECT_EQ(tire.damping, entry.damping);
      EXPECT_EQ(tire.shape.crown_radius, entry.shape.crown_radius);
      EXPECT_EQ(tire.shape.radius, entry.shape.radius);
    }
  }
}

TEST(InflationPressure, InterpolatesLinearlyBetweenTwo) {
  for (const Tested& tested : kTested) {
    const Tire low = Found(tested.low), high = Found(tested.high), tire = Found(tested.middle);
    for (double d : {0.01, 0.05, 0.2}) {
      EXPECT_NEAR(SpringPressure(tire.spring, d) * 2 /
                      (SpringPressure(low.spring, d) + SpringPressure(high.spring, d)),
                  1, 1e-5);
    }
    EXPECT_NEAR(tire.damping * 2 / (low.damping + high.damping), 1, 1e-5);
    EXPECT_EQ(tire.shape.width, low.shape.width);
    if (std::isinf(low.shape.crown_radius)) {
      EXPECT_TRUE(std::isinf(tire.shape.crown_radius));
    } else {
      EXPECT_NEAR(tire.shape.crown_radius * 2, low.shape.crown_radius + high.shape.crown_radius,
                  1e-9);
    }
  }
}

TEST(InflationPressure, CarriesMoreTheHigherItIs) {
  double last = 0;
  for (int pressure = 85; pressure <= 125; pressure += 5) {
    const double load = LoadOf("18.4R38@" + std::to_string(pressure) + "kPa");
    EXPECT_GT(load, last * 1.01) << pressure;
    last = load;
  }
  EXPECT_EQ(last, LoadOf("18.4R38_125kPa"));
  EXPECT_GT(LoadOf("18.4R38@85.5kPa"), LoadOf("18.4R38_85kPa"));
}

TEST(InflationPressure, IsNeverExtrapolated) {
  const std::string rule = ": the inflation pressure must be 85 to 125 kPa as tested, got ";
  EXPECT_EQ(RefusalOf("18.4R38@200kPa"), "tire \"18.4R38@200kPa\"" + rule + "200 kPa");
  EXPECT_EQ(RefusalOf("18.4R38@12psi"), "tire \"18.4R38@12psi\"" + rule + "82.737 kPa");
  EXPECT_THAT(RefusalOf("24.5R32@125kPa"), HasSubstr("must be 85 kPa as tested, got 125 kPa"));
}

TEST(InflationPressure, NeedsAPressureWithItsUnit) {
  for (const std::string text :
       {"", "100", "kPa", "-100kPa", "0kPa", "100m", "100 kPa", "nankPa"}) {
    EXPECT_EQ(RefusalOf("18.4R38@" + text),
              "tire \"18.4R38@" + text +
                  "\": after @ there must be a pressure > 0 and its unit, one of "
                  "Pa, kPa, bar, psi, got \"" +
                  text + "\"");
  }
}

TEST(InflationPressure, NeedsAKnownFamily) {
  EXPECT_THAT(RefusalOf("18.4R39@100kPa"),
              testing::AllOf(HasSubstr("unknown tire family \"18.4R39\" in \"18.4R39@100kPa\""),
                             HasSubstr("18.4R38 (85 to 125 kPa)"), HasSubstr("24.5R32 (85 kPa)")));
  EXPECT_THAT(RefusalOf("@100kPa"), HasSubstr("unknown tire family \"\""));
  EXPECT_THAT(RefusalOf("18.4R38"), HasSubstr("unknown tire \"18.4R38\"; known are: "));
}

std::string Member(const std::string& name, int pressure) {
  return "<tire name=\"" + name +
         "\">\n"
         "<shape type=\"torus\" radius=\"0.9\" crown_radius=\"0.6\" width=\"0.5\" source=\"a\"/>\n"
         "<spring linear=\"1e6\" damping=\"0\" source=\"a\"/>\n"
         "<friction coefficient=\"0.65\" source=\"a\"/>\n"
         "<inflation family=\"F\" pressure=\"" +
         std::to_string(pressure) + "\" source=\"a\"/>\n</tire>\n";
}

// The sentence with which a second member is refused, after the place and the entry's name.
std::string SecondRefused(const std::string& second) {
  const std::string path =
      WriteFile("tires.xml", "<tires>\n" + Member("one", 100000) + second + "</tires>\n");
  const std::string refusal = RefusalAt(path, [&] { TireCatalogue().AddFile(path); });
  const std::string place = ":8: <tire name=\"two\">: ";
  EXPECT_EQ(refusal.substr(0, place.size()), refusal.empty() ? "" : place);
  return refusal.empty() ? "" : refusal.substr(place.size());
}

TEST(TireFamily, HoldsTiresThatDifferInPressureOnly) {
  const std::string two = Member("two", 200000);
  EXPECT_EQ(SecondRefused(two), "");
  EXPECT_EQ(SecondRefused(Replaced(two, "crown_radius=\"0.6\"", "crown_radius=\"0.5\"")), "");
  const std::string same = "tires of the family \"F\" must have the same ";
  EXPECT_EQ(SecondRefused(Replaced(two, " radius=\"0.9\"", " radius=\"0.8\"")),
            same + "radius, 0.9 in \"one\", got 0.8");
  EXPECT_EQ(SecondRefused(Replaced(two, "width=\"0.5\"", "width=\"0.4\"")),
            same + "width, 0.5 in \"one\", got 0.4");
  EXPECT_EQ(SecondRefused(Replaced(two, "0.65", "0.7")),
            same + "friction, 0.65 in \"one\", got 0.7");
  const std::string lugs =
      "<lugs height=\"0.04\" count=\"20\" void_share=\"0.7\" source=\"a\"/>\n<friction";
  EXPECT_EQ(SecondRefused(Replaced(two, "<friction", lugs)),
            same + "lugs, those in \"one\", got others");
  EXPECT_EQ(SecondRefused(Replaced(two, "linear=\"1e6\"", "linear=\"1e6\" root=\"1\"")),
            same + "terms of the spring, linear in \"one\", got linear, root");
  EXPECT_EQ(
      SecondRefused(Replaced(Replaced(two, "torus", "cylinder"), " crown_radius=\"0.6\"", "")),
      same + "type of shape, torus in \"one\", got cylinder");
  EXPECT_EQ(SecondRefused(Member("two", 100000)),
            "\"one\" is the tire of the family \"F\" at 100 kPa already");
}

TEST(TireFamily, HasNoAtSignInItsMembersNames) {
  const std::string path = WriteFile("tires.xml", "<tires>" + Member("a@b", 1) + "</tires>");
  EXPECT_THAT(RefusalAt(path, [&] { TireCatalogue().AddFile(path); }),
              HasSubstr("the name must not hold an @"));
}

}  // namespace
}  // namespace softsoil
