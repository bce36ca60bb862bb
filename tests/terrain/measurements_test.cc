#include "terrain/measurements.h"

#include <gmock/gmock.h>
#include <unistd.h>

#include <fstream>

#include "terrain/input_error.h"

namespace softsoil {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;

// Tests run in parallel, each in a process of its own.
std::string File() {
  return testing::TempDir() + "measurements_" + std::to_string(getpid()) + ".csv";
}

Measurements FromText(const std::string& text, std::size_t least_rows = 1) {
  std::ofstream(File()) << text;
  return Measurements(File(), {{"sinkage", Quantity::kLength}, {"pressure", Quantity::kPressure}},
                      least_rows);
}

template <class Act>
void ExpectRefused(const Act& act, const std::string& line_and_rule) {
  try {
    act();
    FAIL() << "accepted; expected " << line_and_rule;
  } catch (const InputError& error) {
    EXPECT_EQ(error.what(), File() + line_and_rule);
  }
}

TEST(Measurements, ComeInSiWhateverTheUnitAndOrderOfTheFile) {
  const Measurements table = FromText("# plate 1\npressure [psi], sinkage[in]\n1, 2\n10, 3\n");
  EXPECT_EQ(table.rows(), 2u);
  EXPECT_THAT(table.Column("sinkage"), ElementsAre(0.0508, 0.0762));
  EXPECT_THAT(table.Column("pressure"),
              ElementsAre(DoubleNear(6894.757293168, 1e-6), DoubleNear(68947.57293168, 1e-5)));
}

// 9 * 0.001 is 0.009000000000000001, 2.1 / 1000 is 0.0021000000000000003.
TEST(Measurements, KeepTheDigitsThatAreWritten) {
  EXPECT_THAT(
      FromText("sinkage [mm],pressure [kPa]\n9,1.001\n2.1,0.161\n1e-3,-2\n").Column("sinkage"),
      ElementsAre(0.009, 0.0021, 1e-6));
  const Unit &mm = *FindUnit(Quantity::kLength, "mm"), &bar = *FindUnit(Quantity::kPressure, "bar");
  const Unit &cm = *FindUnit(Quantity::kLength, "cm"), &kPa = *FindUnit(Quantity::kPressure, "kPa");
  for (int reading = -20000; reading <= 20000; ++reading) {
    const std::string text = std::to_string(reading);
    const double tenths = std::stod(text + "e-1"), thousandths = std::stod(text + "e-3");
    ASSERT_EQ(InSi(tenths, mm), std::stod(text + "e-4")) << text;
    ASSERT_EQ(InSi(tenths, cm), std::stod(text + "e-3")) << text;
    ASSERT_EQ(InSi(thousandths, kPa), reading) << text;
    ASSERT_EQ(InSi(thousandths, bar), std::stod(text + "e2")) << text;
  }
}

TEST(Measurements, ConvertTheLargestAndSmallestNumbers) {
  const Unit &mm = *FindUnit(Quantity::kLength, "mm"), &kPa = *FindUnit(Quantity::kPressure, "kPa");
  EXPECT_EQ(InSi(1e308, mm), 1e305);
  EXPECT_EQ(InSi(1e-322, mm), 0);
  EXPECT_EQ(InSi(1e300, kPa), 1e303);
  EXPECT_EQ(InSi(0, kPa), 0);
  ExpectRefused([] { FromText("sinkage [mm],pressure [kPa]\n1,2\n1,1e308\n"); },
                ":3: pressure is too large, got 1e308 kPa");
  ExpectRefused([] { FromText("sinkage [mm],pressure [psi]\n1,-1e308\n"); },
                ":2: pressure is too large, got -1e308 psi");
}

TEST(Measurements, RefuseAHeaderThatIsNotClear) {
  const auto header = [](const std::string& text) { return [text] { FromText(text); }; };
  ExpectRefused(header(""), ":1: the line with the names of the columns is missing");
  ExpectRefused(header("sinkage [m]\n1\n"), ":1: column pressure is missing");
  ExpectRefused(header("sinkage [m],pressure\n1,2\n"),
                ":1: column pressure must state its unit as pressure [unit], one of Pa, kPa, bar, "
                "psi, got \"\"");
  ExpectRefused(header("sinkage [kPa],pressure [kPa]\n1,2\n"),
                ":1: column sinkage must state its unit as sinkage [unit], one of m, cm, mm, in, "
                "got \"kPa\"");
  ExpectRefused(header("sinkage [m],sinkage [m]\n1,2\n"),
                ":1: column \"sinkage\" stands here a second time");
  ExpectRefused(header("#\nsinkage [m],load [N]\n1,2\n"),
                ":2: unknown column \"load\"; the columns are: sinkage, pressure");
}

TEST(Measurements, RefuseWhatIsNoFile) {
  const auto refusal = [](const std::string& file) -> std::string {
    try {
      Measurements(file, {{"sinkage", Quantity::kLength}}, 1);
    } catch (const InputError& error) {
      return error.what();
    }
    return "accepted";
  };
  const std::string folder = testing::TempDir(), missing = folder + "no_such.csv";
  const std::string long_name = folder + std::string(300, 'a') + ".csv";
  EXPECT_EQ(refusal(folder), folder + ": is a folder, not a file");
  EXPECT_EQ(refusal(missing), missing + ": cannot read: No such file or directory");
  EXPECT_EQ(refusal(long_name), long_name + ": cannot read: File name too long");
}

TEST(Measurements, RefuseBadRowsWithTheirLine) {
  const std::string header = "sinkage [mm],pressure [kPa]\n";
  ExpectRefused([&] { FromText(header + "1\n"); },
                ":2: there must be 2 cells as in the header, got 1");
  ExpectRefused([&] { FromText(header + "1,2\n\n1,two\n"); },
                ":4: pressure must be a finite number, got \"two\"");
  ExpectRefused([&] { FromText(header + "1,2\n", 3); }, ":2: there must be at least 3 rows, got 1");
  ExpectRefused([&] { FromText(header + "1,2\n1,-3\n").RequireNotNegative("pressure"); },
                ":3: pressure must be >= 0 Pa, got -3000 Pa");
  ExpectRefused([&] { FromText(header + "0,2\n1,3\n").RequirePositive("sinkage"); },
                ":2: sinkage must be > 0 m, got 0 m");
}

}  // namespace
}  // namespace softsoil
