#include "terrain/shear_fit.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "terrain/constants.h"
#include "terrain/input_error.h"
#include "tests/terrain/catalogue_case.h"
#include "tests/terrain/soil_test_noise.h"

namespace softsoil {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

// North Gower clayey loam of Wong (2008): c 6.1 kPa, phi 26.6 deg; K 1.25 cm.
constexpr double kC = 6100, kPhi = 26.6 * kPi / 180, kK = 0.0125;

ShearTest Sheared(const std::vector<double>& stresses, double c, double phi, double K) {
  ShearTest test;
  for (double sigma : stresses) {
    for (double j = 0; j < 0.0601; j += 0.004) {
      test.normal_stress.push_back(sigma);
      test.displacement.push_back(j);
      test.shear_stress.push_back((c + sigma * std::tan(phi)) * (1 - std::exp(-j / K)));
    }
  }
  return test;
}
ShearTest ThreeStresses() { return Sheared({10e3, 30e3, 60e3}, kC, kPhi, kK); }

TEST(FitShear, RecoversTheParametersOfExactReadings) {
  for (double phi : {0.05, kPhi, 0.7}) {
    for (double K : {0.004, kK, 0.1}) {
      const ShearFit fit = FitShear(Sheared({10e3, 30e3, 60e3}, kC, phi, K));
      EXPECT_EQ(fit.bound, StrengthBound::kNone);
      EXPECT_NEAR(fit.cohesion.value, kC, 1e-6 * kC);
      EXPECT_NEAR(fit.friction_angle.value, phi, 1e-6 * phi);
      EXPECT_NEAR(fit.modulus.value, K, 1e-6 * K);
      EXPECT_EQ(fit.is_short, K > 0.03);
    }
  }
}

double WorstError(const ShearFit& fit) {
  return std::max({std::abs(fit.cohesion.value / kC - 1),
                   std::abs(fit.friction_angle.value / kPhi - 1),
                   std::abs(fit.modulus.value / kK - 1)});
}

// 16 readings at each of three normal stresses, each off by a normal error of 2 % of itself, seeds
// 1 to 100.
TEST(FitShear, IsWithinFivePercentUnderTwoPercentNoise) {
  int close = 0;
  double sum = 0;
  for (unsigned seed = 1; seed <= 100; ++seed) {
    Noise noise(seed);
    ShearTest test = ThreeStresses();
    test.shear_stress = WithRelativeNoise(test.shear_stress, 0.02, &noise);
    const double error = WorstError(FitShear(test));
    sum += error;
    close += error < 0.05 ? 1 : 0;
  }
  RecordProperty("close", close);
  RecordProperty("mean_worst_error_ppm", static_cast<int>(sum / 100 * 1e6));
  EXPECT_GE(close, 90);
  EXPECT_LT(sum / 100, 0.03);
}

TEST(FitShear, IntervalsCoverTheTruthAsOftenAsTheySay) {
  int angles = 0, moduli = 0;
  constexpr int kExperiments = 400;
  for (unsigned seed = 1; seed <= kExperiments; ++seed) {
    Noise noise(seed);
    ShearTest test = ThreeStresses();
    test.shear_stress = WithNoise(test.shear_stress, 500, &noise);
    const ShearFit fit = FitShear(test);
    const Fitted &phi = fit.friction_angle, &K = fit.modulus;
    angles += std::abs(phi.value - kPhi) <= phi.confidence ? 1 : 0;
    moduli += std::abs(K.value - kK) <= K.confidence ? 1 : 0;
  }
  for (int covered : {angles, moduli}) {
    EXPECT_GT(covered, 0.92 * kExperiments);
    EXPECT_LT(covered, 0.98 * kExperiments);
  }
}

TEST(FitShear, ReportsTheResidualsThatItLeaves) {
  Noise noise(3);
  ShearTest test = ThreeStresses();
  test.shear_stress = WithNoise(test.shear_stress, 500, &noise);
  const ShearFit fit = FitShear(test);
  double squares = 0;
  for (std::size_t i = 0; i < fit.fitted.size(); ++i) {
    const double strength =
        fit.cohesion.value + test.normal_stress[i] * std::tan(fit.friction_angle.value);
    EXPECT_NEAR(fit.fitted[i], strength * (1 - std::exp(-test.displacement[i] / fit.modulus.value)),
                1e-6 * 6e4);
    squares += std::pow(fit.fitted[i] - test.shear_stress[i], 2);
  }
  EXPECT_NEAR(fit.rms, std::sqrt(squares / static_cast<double>(fit.fitted.size())), 1e-6);
}

TEST(FitShear, HoldsANegativeCohesionAtZeroAndSaysSo) {
  const ShearFit fit = FitShear(Sheared({10e3, 30e3, 60e3}, -2000, kPhi, kK));
  EXPECT_EQ(fit.bound, StrengthBound::kNoCohesion);
  EXPECT_EQ(fit.cohesion.value, 0);
  EXPECT_NEAR(fit.free_value, -2000, 1);
  EXPECT_NEAR(fit.friction_angle.value, kPhi, 0.1);
  EXPECT_LT(fit.friction_angle.value, kPhi);
}

TEST(FitShear, HoldsANegativeFrictionAtZeroAndSaysSo) {
  const ShearFit fit = FitShear(Sheared({10e3, 30e3, 60e3}, 30e3, -0.1, kK));
  EXPECT_EQ(fit.bound, StrengthBound::kNoFriction);
  EXPECT_EQ(fit.friction_angle.value, 0);
  EXPECT_NEAR(fit.free_value, -0.1, 1e-6);
  EXPECT_NEAR(fit.cohesion.value, 27e3, 2e3);
}

TEST(FitShear, NoticesACurveThatFallsAfterItsPeak) {
  EXPECT_FALSE(FitShear(ThreeStresses()).falls_after_peak);
  ShearTest test = ThreeStresses();
  test.shear_stress.back() *= 0.7;
  EXPECT_TRUE(FitShear(test).falls_after_peak);
}

TEST(FitShear, NeedsASecondNormalStress) {
  EXPECT_THAT([] { FitShear(Sheared({20e3}, kC, kPhi, kK)); },
              ThrowsMessage<InputError>("one normal stress, 20000 Pa, does not determine cohesion "
                                        "and friction angle; test a second one"));
}

// Of 20 and 20.1 kPa any noise would become an angle.
TEST(FitShear, NeedsNormalStressesThatLieApart) {
  EXPECT_THAT(
      [] {
        FitShear(Sheared({20e3, 20.1e3}, kC, kPhi, kK));
      },
      ThrowsMessage<InputError>(HasSubstr("must lie apart by at least 0.05 of the greatest")));
}

TEST(FitShear, RefusesReadingsThatDoNotBeginToLevelOff) {
  const ShearTest test = Sheared({10e3, 30e3, 60e3}, kC, kPhi, 0.5);
  EXPECT_THAT(
      [&] { FitShear(test); },
      ThrowsMessage<InputError>(HasSubstr("at most 5 times the longest displacement, 0.06 m")));
}

constexpr char kHeader[] = "normal_stress [kPa], displacement [mm], shear_stress [kPa]\n";

std::string Refusal(const std::string& rows) {
  const std::string path = WriteFile("shear.csv", kHeader + rows);
  return RefusalAt(path, [&] { ReadShearTest(path); });
}

TEST(ReadShearTest, RefusesWhatIsNoTestWithRowAndRule) {
  EXPECT_EQ(Refusal("10,5,4\n"), ":2: there must be at least 3 rows, got 1");
  EXPECT_EQ(Refusal("10,5,4\n10,10,6\n10,15,7\n30,5,9\n"),
            ":5: the test at normal stress 30000 Pa must have at least 3 rows, got 1");
  EXPECT_EQ(Refusal("10,5,4\n10,10,-6\n10,15,7\n"),
            ":3: shear_stress must be >= 0 Pa, got -6000 Pa");
  EXPECT_EQ(Refusal("10,5,4\n10,10,6\n10,8,7\n"),
            ":4: displacement of the test at normal stress 10000 Pa must rise from row to row, got "
            "0.008 m after 0.01 m");
  EXPECT_EQ(Refusal("10,5,4\n10,10,6\n-10,9,7\n"),
            ":4: normal_stress must be >= 0 Pa, got -10000 Pa");
}

}  // namespace
}  // namespace softsoil
