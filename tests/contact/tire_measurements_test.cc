// Load-deflection files, and how bad ones are refused.
#include "contact/tire_measurements.h"

#include <gtest/gtest.h>

#include "tests/terrain/catalogue_case.h"

namespace softsoil {
namespace {

const std::string kOne = "# a test\ndeflection [cm], load [kN]\n0, 0\n2, 3.1\n4, 8.3\n6, 14.6\n";
const std::string kTwo =
    "load [kN], inflation_pressure [kPa], deflection [m]\n"
    "1, 125, 0.01\n2, 85, 0.02\n3, 85, 0.03\n4, 85, 0.04\n"
    "5, 125, 0.03\n6, 125, 0.04\n7, 125, 0.05\n8, 85, 0.05\n";

std::string RefusalOf(const std::string& csv) {
  const std::string path = WriteFile("tire.csv", csv);
  return RefusalAt(path, [&] { ReadLoadDeflection(path, 0.5); });
}

TEST(LoadDeflectionFile, HoldsOneTest) {
  const auto tests = ReadLoadDeflection(WriteFile("tire.csv", kOne), 0.5);
  ASSERT_EQ(tests.size(), 1u);
  EXPECT_EQ(tests[0].inflation_pressure, 0);
  EXPECT_EQ(tests[0].rows.deflection, (std::vector<double>{0, 0.02, 0.04, 0.06}));
  EXPECT_EQ(tests[0].rows.load, (std::vector<double>{0, 3100, 8300, 14600}));
}

TEST(LoadDeflectionFile, HoldsSeveralPressuresInAnyOrder) {
  const auto tests = ReadLoadDeflection(WriteFile("tire.csv", kTwo), 0.5);
  ASSERT_EQ(tests.size(), 2u);
  EXPECT_EQ(tests[0].inflation_pressure, 85e3);
  EXPECT_EQ(tests[0].rows.load, (std::vector<double>{2e3, 3e3, 4e3, 8e3}));
  EXPECT_EQ(tests[1].inflation_pressure, 125e3);
  EXPECT_EQ(tests[1].rows.deflection, (std::vector<double>{0.01, 0.03, 0.04, 0.05}));
}

TEST(LoadDeflectionFile, NeedsItsColumnsWithUnits) {
  EXPECT_EQ(RefusalOf(Replaced(kOne, ", load [kN]", "")), ":2: column load is missing");
  EXPECT_EQ(RefusalOf(Replaced(kOne, " [cm]", "")),
            ":2: column deflection must state its unit as deflection [unit], one of m, cm, mm, in, "
            "got \"\"");
  EXPECT_EQ(RefusalOf(Replaced(kTwo, "[kPa]", "[mm]")).substr(0, 29),
            ":1: column inflation_pressure");
}

TEST(LoadDeflectionFile, NeedsMoreRowsThanASpringHasTerms) {
  const std::string rule =
      "there must be at least 4 rows, one more than the largest form of spring has terms, got 3";
  EXPECT_EQ(RefusalOf(Replaced(kOne, "0, 0\n", "")), ": " + rule);
  EXPECT_EQ(RefusalOf(Replaced(kTwo, "6, 125, 0.04\n", "")), ": at 125 kPa " + rule);
}

TEST(LoadDeflectionFile, RefusesRowsThatAreNoLoadTest) {
  EXPECT_EQ(RefusalOf(Replaced(kOne, "4, 8.3", "2, 8.3")),
            ":5: deflection must rise from row to row, got 0.02 m after 0.02 m");
  EXPECT_EQ(RefusalOf(Replaced(kTwo, "4, 85, 0.04", "4, 85, 0.025")),
            ":5: deflection must rise from row to row, got 0.025 m after 0.03 m");
  EXPECT_EQ(RefusalOf(Replaced(kOne, "6, 14.6", "6, 7.4")),
            ":6: load must rise with deflection, got 7400 N after 8300 N");
  EXPECT_EQ(RefusalOf(Replaced(kOne, "6, 14.6", "6, 8.2")), "") << "noise";
  EXPECT_EQ(RefusalOf(Replaced(kOne, "2, 3.1", "2, -3.1")), ":4: load must be >= 0 N, got -3100 N");
  EXPECT_EQ(RefusalOf(Replaced(kOne, "0, 0", "-1, 0")),
            ":3: deflection must be >= 0 m, got -0.01 m");
  EXPECT_EQ(RefusalOf(Replaced(kOne, "0, 0", "0, 3")),
            ":3: load must be 0 N at deflection 0, where the tire only touches, got 3000 N");
  EXPECT_EQ(RefusalOf(Replaced(kOne, "6, 14.6", "50, 99")),
            ":6: deflection must be < the tire's radius 0.5 m, got 0.5 m");
  EXPECT_EQ(RefusalOf(Replaced(kTwo, "2, 85,", "2, 0,")),
            ":3: inflation_pressure must be > 0 Pa, got 0 Pa");
  EXPECT_EQ(RefusalOf("deflection [m], load [N]\n0.1,0\n0.2,0\n0.3,0\n0.4,0\n"),
            ": load must rise with deflection, got 0 N in every row");
  EXPECT_EQ(RefusalOf("deflection [m], load [N]\n0.1,7\n0.2,7\n0.3,7\n0.4,7\n"),
            ": load must rise with deflection, got 7 N in every row");
}

TEST(ContactWidthFile, HoldsDeflectionAndWidth) {
  const auto refusal = [](const std::string& csv) {
    const std::string path = WriteFile("width.csv", csv);
    return RefusalAt(path, [&] { ReadContactWidths(path, 0.5); });
  };
  const std::string csv = "deflection [in], contact_width [in]\n1, 8\n2, 11\n";
  const ContactWidths widths = ReadContactWidths(WriteFile("width.csv", csv), 0.5);
  EXPECT_EQ(widths.width, (std::vector<double>{8 * 0.0254, 11 * 0.0254}));
  EXPECT_EQ(refusal(Replaced(csv, "1, 8\n", "")), ":2: there must be at least 2 rows, got 1");
  EXPECT_EQ(refusal(Replaced(csv, "1, 8", "0, 8")), ":2: deflection must be > 0 m, got 0 m");
  EXPECT_EQ(refusal(Replaced(csv, "2, 11", "20, 11")),
            ":3: deflection must be < the tire's radius 0.5 m, got 0.508 m");
}

}  // namespace
}  // namespace softsoil
