#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "terrain/load_cycle.h"
#include "tests/terrain/test_soil.h"

namespace softsoil {
namespace {

const Compaction kSoil = LooseLoam();
constexpr double kYield = 96e3;  // [Pa]

void ExpectSame(const SoilVolume& a, const SoilVolume& b) {
  EXPECT_EQ(a.density, b.density);
  EXPECT_EQ(a.preconsolidation_density, b.preconsolidation_density);
  EXPECT_EQ(a.preconsolidation_stress, b.preconsolidation_stress);
  EXPECT_EQ(a.peak_density, b.peak_density);
}

TEST(Compression, DoesNotStartBelowThePreconsolidationStress) {
  const SoilVolume fresh = UndisturbedVolume(kSoil);
  SoilVolume volume = fresh;
  for (int i = 0; i < 1000; ++i) Advance(kSoil, 0.999 * kYield, 0.01, volume);
  ExpectSame(volume, fresh);
}

TEST(Compression, StartsJustAboveThePreconsolidationStress) {
  SoilVolume volume = UndisturbedVolume(kSoil);
  Advance(kSoil, 1.001 * kYield, 0.01, volume);
  EXPECT_GT(volume.density, 1200);
}

TEST(Compression, TakesTheTimeConstantForSixtyThreePercent) {
  SoilVolume volume = UndisturbedVolume(kSoil);
  for (int i = 0; i < 200; ++i) Advance(kSoil, 10 * kYield, 1e-3, volume);
  EXPECT_NEAR(volume.density, 1200 + 500 * (1 - std::exp(-1.0)), 1e-9);
}

TEST(Compression, TendsToTheVirginCurve) {
  SoilVolume volume = UndisturbedVolume(kSoil);
  for (int i = 0; i < 1000; ++i) Advance(kSoil, 250e3, 0.01, volume);
  EXPECT_NEAR(volume.density, 1200 + 500 * std::log10(250.0 / 96), 1e-9);
}

TEST(Compression, NeverPassesTheVirginCurveHoweverLongTheStep) {
  SoilVolume volume = UndisturbedVolume(kSoil);
  Advance(kSoil, 250e3, 1e6, volume);
  EXPECT_LE(volume.density, 1200 + 500 * std::log10(250.0 / 96) + 1e-9);
}

TEST(Compression, OfALooserSoilStartsEarlier) {
  Compaction looser = kSoil;
  looser.initial_density = 1100;
  EXPECT_NEAR(UndisturbedVolume(looser).preconsolidation_stress, kYield * std::pow(10, -0.2), 1e-6);
}

TEST(Compression, IsNotLessUnderHigherStress) {
  double last = 0;
  for (double peak = 50e3; peak < 800e3; peak += 10e3) {
    SoilVolume volume = UndisturbedVolume(kSoil);
    for (int i = 0; i < 5; ++i) Advance(kSoil, peak, 0.01, volume);
    EXPECT_GE(volume.density, last) << peak;
    last = volume.density;
  }
  EXPECT_GT(last, 1200);
}

TEST(Compression, IsNotLessUnderAHigherLoadCycle) {
  double last = 0;
  for (double peak = 50e3; peak < 800e3; peak += 10e3) {
    SoilVolume volume = UndisturbedVolume(kSoil);
    ApplyCycle(kSoil, {peak, 0.2, 1e-3}, volume);
    EXPECT_GE(volume.density, last) << peak;
    last = volume.density;
  }
  EXPECT_GT(last, 1200);
}

TEST(Compression, NeedsALoad) {
  SoilVolume used = UndisturbedVolume(kSoil);
  ApplyCycle(kSoil, {300e3, 0.2, 1e-3}, used);
  for (const SoilVolume& start : {UndisturbedVolume(kSoil), used}) {
    SoilVolume volume = start;
    for (int i = 0; i < 1000; ++i) Advance(kSoil, i % 2 == 0 ? 0 : -50e3, 0.01, volume);
    ExpectSame(volume, start);
  }
}

TEST(Compression, StaysFiniteAndAboveTheStartInAnyLoadHistory) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> stress(-1e5, 6e5), time(1e-4, 0.1);
  SoilVolume volume = UndisturbedVolume(kSoil);
  for (int i = 0; i < 10000; ++i) {
    Advance(kSoil, stress(random), time(random), volume);
    ASSERT_GE(volume.density, volume.preconsolidation_density);
    ASSERT_GE(volume.preconsolidation_stress, 0.999999 * kYield);
    ASSERT_LT(volume.density, 1200 + 500 * std::log10(6e5 / kYield) + 1e-6);
  }
}

TEST(CompactionEnergy, IsStressTimesStrain) {
  EXPECT_DOUBLE_EQ(CompactionEnergy(100e3, 1200, 1600), 100e3 * 0.25);
}

TEST(CompactionEnergy, IsNotGivenBackInRebound) {
  EXPECT_EQ(CompactionEnergy(100e3, 1600, 1200), 0);
}

}  // namespace
}  // namespace softsoil
