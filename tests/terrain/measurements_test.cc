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
  EXPECT_THAT(table.Column("sinkage"), ElementsAre(DoubleNear(0.0508, 1e-15), 3 * 0.0254));
  EXPECT_THAT(table.Column("pressure"),
              ElementsAre(DoubleNear(6894.757293168, 1e-6), DoubleNear(68947.57293168, 1e-5)));
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
