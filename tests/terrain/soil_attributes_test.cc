// One table says what a soil file holds.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <set>
#include <string>

#include "tests/terrain/soil_file_case.h"

namespace softsoil {
namespace {

TEST(SoilAttributes, AreAllRead) {
  Catalogue<Soil> soils = SoilCatalogue();
  soils.AddFile(WriteFile("soil.xml", SoilXml("all")));
  Soil soil = soils.Find("all");
  const std::vector<Attribute<Soil>>& table = SoilAttributes();
  ASSERT_GE(table.size(), 14u);
  for (std::size_t i = 0; i < table.size(); ++i) {
    EXPECT_DOUBLE_EQ(table[i].field(soil), SampleValue(i) * table[i].to_si) << table[i].name;
  }
}

TEST(SoilAttributes, AreAllRequired) {
  for (const Attribute<Soil>& attribute : SoilAttributes()) {
    const std::string refusal = SoilRefusal(SoilXml("s", &attribute));
    EXPECT_EQ(refusal.substr(refusal.find(": ") + 2), std::string("<soil name=\"s\"> <") +
                                                          attribute.element + ">: attribute " +
                                                          attribute.name + " is missing");
  }
}

TEST(SoilAttributes, FillFieldsOfTheirOwn) {
  Soil soil{};
  std::set<double*> fields;
  for (const Attribute<Soil>& attribute : SoilAttributes()) fields.insert(&attribute.field(soil));
  EXPECT_EQ(fields.size(), SoilAttributes().size());
}

TEST(SoilAttributes, AllSayWhatTheyMean) {
  for (const Attribute<Soil>& attribute : SoilAttributes()) {
    EXPECT_GT(std::strlen(attribute.meaning), 5u) << attribute.name;
  }
}

TEST(SoilAttributes, AreRefusedOutsideTheirRange) {
  for (std::size_t i = 0; i < SoilAttributes().size(); ++i) {
    const Attribute<Soil>& a = SoilAttributes()[i];
    const std::string good = " " + std::string(a.name) + "=\"" + Shown(SampleValue(i)) + "\"";
    const std::string bad = " " + std::string(a.name) + "=\"-1\"";
    const std::string unit = *a.unit != '\0' ? " " + std::string(a.unit) : "";
    const std::string refusal = SoilRefusal(Replaced(SoilXml("s"), good, bad));
    EXPECT_EQ(refusal.substr(refusal.find(">: ") + 3),
              std::string(a.name) + " must be " + InWords(a.range) + unit + ", got -1");
  }
}

TEST(SoilAttributes, InDegreesBecomeRadians) {
  Catalogue<Soil> soils = SoilCatalogue();
  soils.AddFile(WriteFile("soil.xml", Replaced(SoilXml("s"), "friction_angle_deg=\"3.5\"",
                                               "friction_angle_deg=\"30\"")));
  EXPECT_NEAR(soils.Find("s").shear.friction_angle, std::acos(-1.0) / 6, 1e-12);
}

TEST(Range, HoldsItsBoundsAsSaid) {
  const double inf = std::numeric_limits<double>::infinity(), nan = std::nan("");
  EXPECT_TRUE(Contains(Range::kNotNegative, 0));
  EXPECT_FALSE(Contains(Range::kNotNegative, -1e-300));
  EXPECT_FALSE(Contains(Range::kPositive, 0));
  EXPECT_TRUE(Contains(Range::kPositive, 1e-300));
  EXPECT_TRUE(Contains(Range::kUpTo90Degrees, 0));
  EXPECT_FALSE(Contains(Range::kUpTo90Degrees, 90));
  EXPECT_TRUE(Contains(Range::kConcentration, 3));
  EXPECT_TRUE(Contains(Range::kConcentration, 6));
  EXPECT_FALSE(Contains(Range::kConcentration, 2.99));
  EXPECT_FALSE(Contains(Range::kConcentration, 6.01));
  EXPECT_TRUE(Contains(Range::kAny, -1e300));
  for (Range range : {Range::kAny, Range::kNotNegative, Range::kPositive, Range::kUpTo90Degrees,
                      Range::kConcentration}) {
    EXPECT_FALSE(Contains(range, inf));
    EXPECT_FALSE(Contains(range, -inf));
    EXPECT_FALSE(Contains(range, nan));
  }
}

}  // namespace
}  // namespace softsoil
