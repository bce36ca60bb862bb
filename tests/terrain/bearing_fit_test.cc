#include "terrain/bearing_fit.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "terrain/input_error.h"
#include "tests/terrain/catalogue_case.h"
#include "tests/terrain/soil_test_noise.h"

namespace softsoil {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

// Upland sandy loam of Wong (2008): k_c 74.6 kN/m^(n+1), k_phi 2080 kN/m^(n+2), n 1.1.
constexpr double kKc = 74600, kKphi = 2080e3, kN = 1.1;
constexpr double kK1 = 20e3, kK2 = 400e3;  // Reece form [Pa], [Pa/m]

PlateSinkage Pressed(std::vector<double> widths, double (*pressure)(double b, double z)) {
  PlateSinkage test;
  for (double b : widths) {
    for (double z = 0; z < 0.1501; z += 0.0025) {
      test.width.push_back(b);
      test.sinkage.push_back(z);
      test.pressure.push_back(pressure(b, z));
    }
  }
  return test;
}

double Bekker(double b, double z) { return (kKc / b + kKphi) * std::pow(z, kN); }
double Reece(double b, double z) { return (kK1 + kK2 * b) * std::pow(z / b, kN); }
double Weaker(double b, double z) { return (-0.01 * kKphi / b + kKphi) * std::pow(z, kN); }

PlateSinkage TwoPlates() { return Pressed({0.05, 0.3}, Bekker); }

TEST(FitBearing, RecoversTheParametersOfExactReadings) {
  for (const auto& widths : {std::vector<double>{0.05, 0.3}, {0.1, 0.15}, {0.05, 0.1, 0.2, 0.5}}) {
    const BearingFit fit = FitBearing(Pressed(widths, Bekker));
    EXPECT_EQ(fit.basis, ModuliFrom::kPlates);
    EXPECT_EQ(fit.widths, widths);
    EXPECT_NEAR(fit.cohesive.value, kKc, 1e-6 * kKc);
    EXPECT_NEAR(fit.frictional.value, kKphi, 1e-6 * kKphi);
    EXPECT_NEAR(fit.exponent.value, kN, 1e-6 * kN);
    EXPECT_LT(fit.rms, 1e-3);
  }
}

TEST(FitBearing, RecoversTheFormOfReece) {
  const BearingFit fit = FitBearing(Pressed({0.05, 0.1, 0.3}, Reece), BearingForm::kReece);
  EXPECT_NEAR(fit.cohesive.value, kK1, 1e-6 * kK1);
  EXPECT_NEAR(fit.frictional.value, kK2, 1e-6 * kK2);
  EXPECT_NEAR(fit.exponent.value, kN, 1e-6 * kN);
}

double WorstError(const BearingFit& fit) {
  return std::max({std::abs(fit.cohesive.value / kKc - 1),
                   std::abs(fit.frictional.value / kKphi - 1),
                   std::abs(fit.exponent.value / kN - 1)});
}

// 60 readings for each of three plates, each off by a normal error of 2 % of itself, seeds 1 to
// 100. k_c, a difference of plates, is the worst.
TEST(FitBearing, IsWithinFivePercentUnderTwoPercentNoise) {
  int close = 0;
  double sum = 0;
  for (unsigned seed = 1; seed <= 100; ++seed) {
    Noise noise(seed);
    PlateSinkage test = Pressed({0.05, 0.15, 0.3}, Bekker);
    test.pressure = WithRelativeNoise(test.pressure, 0.02, &noise);
    const double error = WorstError(FitBearing(test));
    sum += error;
    close += error < 0.05 ? 1 : 0;
  }
  RecordProperty("close", close);
  RecordProperty("mean_worst_error_ppm", static_cast<int>(sum / 100 * 1e6));
  EXPECT_GE(close, 90);
  EXPECT_LT(sum / 100, 0.03);
}

// Noise of one size, 2 % of the mean reading, is what the intervals are made for.
TEST(FitBearing, IntervalsCoverTheTruthAsOftenAsTheySay) {
  int covered = 0;
  constexpr int kExperiments = 400;
  for (unsigned seed = 1; seed <= kExperiments; ++seed) {
    Noise noise(seed);
    PlateSinkage test = TwoPlates();
    test.pressure = WithNoise(test.pressure, 3000, &noise);
    const Fitted k_c = FitBearing(test).cohesive;
    covered += std::abs(k_c.value - kKc) <= k_c.confidence ? 1 : 0;
  }
  EXPECT_GT(covered, 0.92 * kExperiments);
  EXPECT_LT(covered, 0.98 * kExperiments);
}

TEST(FitBearing, ReportsTheResidualsThatItLeaves) {
  Noise noise(1);
  PlateSinkage test = TwoPlates();
  test.pressure = WithNoise(test.pressure, 3000, &noise);
  const BearingFit fit = FitBearing(test);
  double squares = 0;
  int rows = 0;
  for (std::size_t i = 0; i < test.width.size(); ++i) {
    if (test.sinkage[i] <= 0) continue;
    squares += std::pow(fit.fitted[i] - test.pressure[i], 2);
    ++rows;
  }
  EXPECT_NEAR(fit.rms, std::sqrt(squares / rows), 1e-6 * fit.rms);
  EXPECT_NEAR(fit.rms, 3000, 1000);
}

TEST(FitBearing, OfOnePlateKnowsTheSumOfTheModuliAlone) {
  const BearingFit fit = FitBearing(Pressed({0.1}, Bekker));
  EXPECT_EQ(fit.basis, ModuliFrom::kPlatesOfOneWidth);
  EXPECT_NEAR(fit.frictional.value, kKc / 0.1 + kKphi, 1);
  EXPECT_NEAR(fit.exponent.value, kN, 1e-6);
  EXPECT_THAT([] { FitBearing(Pressed({0.1}, Bekker), BearingForm::kReece); },
              ThrowsMessage<InputError>("one plate width, 0.1 m, does not determine k_1 and k_2; "
                                        "test a second one"));
}

TEST(FitBearing, NeedsPlatesThatDiffer) {
  EXPECT_THAT(
      [] {
        FitBearing(Pressed({0.1, 0.1000001}, Bekker));
      },
      ThrowsMessage<InputError>(HasSubstr("at least 1.1 times as wide as the narrowest")));
}

// A narrow plate that bears less than a wide one asks for k_c < 0.
TEST(FitBearing, HoldsANegativeCohesiveModulusAtZeroAndSaysSo) {
  const BearingFit fit = FitBearing(Pressed({0.05, 0.3}, Weaker));
  EXPECT_EQ(fit.basis, ModuliFrom::kNoCohesive);
  EXPECT_EQ(fit.cohesive.value, 0);
  EXPECT_NEAR(fit.free_value, -0.01 * kKphi, 1);
  EXPECT_GT(fit.frictional.value, 0.7 * kKphi);
  EXPECT_LT(fit.frictional.value, kKphi);
  EXPECT_GT(fit.rms, 1000);
}

// A clay bears the same at the same z/b under any plate: k_2 = 0, and noise asks for less as often
// as for more.
TEST(FitBearing, HoldsANegativeFrictionalModulusOfReeceAtZeroAndSaysSo) {
  int held = 0;
  for (unsigned seed = 1; seed <= 40; ++seed) {
    Noise noise(seed);
    PlateSinkage test =
        Pressed({0.05, 0.3}, [](double b, double z) { return 50e3 * std::sqrt(z / b); });
    test.pressure = WithRelativeNoise(test.pressure, 0.01, &noise);
    const BearingFit fit = FitBearing(test, BearingForm::kReece);
    EXPECT_NEAR(fit.cohesive.value, 50e3, 1000) << seed;
    EXPECT_NEAR(fit.exponent.value, 0.5, 0.02) << seed;
    EXPECT_GE(fit.frictional.value, 0) << seed;
    if (fit.basis != ModuliFrom::kNoFrictional) continue;
    ++held;
    EXPECT_EQ(fit.frictional.value, 0);
    EXPECT_LT(fit.free_value, 0);
    EXPECT_GT(fit.cohesive.confidence, 0);
    EXPECT_LT(fit.rms, 0.02 * 50e3 * std::sqrt(3));
  }
  EXPECT_GT(held, 10);
  EXPECT_LT(held, 30);
}

// The wide plate 2 % low asks for k_2 = -4000 Pa/m with certainty.
TEST(FitBearing, HoldsTheFrictionalModulusOfAPlateThatReadsLowAtZero) {
  const BearingFit fit = FitBearing(
      Pressed({0.05, 0.3},
              [](double b, double z) { return (b > 0.1 ? 49e3 : 50e3) * std::sqrt(z / b); }),
      BearingForm::kReece);
  EXPECT_EQ(fit.basis, ModuliFrom::kNoFrictional);
  EXPECT_NEAR(fit.free_value, -1e3 / 0.25, 1);
  EXPECT_GT(fit.cohesive.value, 49e3);
  EXPECT_LT(fit.cohesive.value, 50e3);
}

TEST(FitBearing, RefusesAFrictionalModulusBelowZero) {
  const auto fit = [] {
    FitBearing(Pressed({0.05, 0.3}, [](double b, double z) { return (1e5 / b - 2e5) * z; }));
  };
  EXPECT_THAT(fit, ThrowsMessage<InputError>(HasSubstr("the readings ask for k_phi = -200000")));
}

constexpr char kHeader[] = "width [cm], sinkage [mm], pressure [kPa]\n";

std::string Refusal(const std::string& rows) {
  const std::string path = WriteFile("plate.csv", kHeader + rows);
  return RefusalAt(path, [&] { ReadPlateSinkage(path); });
}

TEST(ReadPlateSinkage, GivesSiByRow) {
  const PlateSinkage test = ReadPlateSinkage(
      WriteFile("plate.csv", std::string(kHeader) + "5,0,0\n5,10,20\n5,20,35\n5,30,45\n"));
  EXPECT_THAT(test.width, testing::Each(0.05));
  EXPECT_DOUBLE_EQ(test.sinkage[3], 0.03);
  EXPECT_DOUBLE_EQ(test.pressure[3], 45e3);
}

TEST(ReadPlateSinkage, RefusesWhatIsNoTestWithRowAndRule) {
  EXPECT_EQ(Refusal("5,10,20\n5,20,35\n"), ":3: there must be at least 3 rows, got 2");
  EXPECT_EQ(
      Refusal("5,10,20\n5,20,35\n5,30,40\n30,10,10\n"),
      ":5: the plate of width 0.3 m must have at least 3 rows with sinkage and pressure, got 1");
  EXPECT_EQ(
      Refusal("5,10,0\n5,20,0\n5,30,40\n"),
      ":4: the plate of width 0.05 m must have at least 3 rows with sinkage and pressure, got "
      "1");
  EXPECT_EQ(Refusal("5,10,20\n5,20,-35\n5,30,40\n"), ":3: pressure must be >= 0 Pa, got -35000 Pa");
  EXPECT_EQ(Refusal("5,10,20\n5,-20,35\n5,30,40\n"), ":3: sinkage must be >= 0 m, got -0.02 m");
  EXPECT_EQ(Refusal("5,10,20\n0,20,35\n5,30,40\n"), ":3: width must be > 0 m, got 0 m");
  EXPECT_EQ(Refusal("5,10,20\n5,20,35\n5,15,40\n"),
            ":4: sinkage of the plate of width 0.05 m must rise from row to row, got 0.015 m after "
            "0.02 m");
  EXPECT_EQ(Refusal("5,10,20\n5,20,35\n5,30,30\n"),
            ":4: pressure must not fall while the plate of width 0.05 m sinks, got 30000 Pa after "
            "35000 Pa");
  EXPECT_EQ(Refusal("5,0,5\n5,20,35\n5,30,40\n"),
            ":2: pressure must be 0 Pa where the sinkage is 0, got 5000 Pa");
}

TEST(ReadPlateSinkage, LetsNoiseLowerThePressureALittle) {
  EXPECT_EQ(Refusal("5,10,20\n5,20,35\n5,21,33\n"), "");
}

}  // namespace
}  // namespace softsoil
