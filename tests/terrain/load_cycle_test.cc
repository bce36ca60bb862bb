#include "terrain/load_cycle.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/terrain/test_soil.h"

namespace softsoil {
namespace {

const LoadCycle kPass{300e3, 0.2, 1e-3};

TEST(LoadCycle, EndsWithThePreconsolidationPointOnTheVirginCurve) {
  const Compaction soil = LooseLoam();
  SoilVolume volume = UndisturbedVolume(soil);
  for (int pass = 0; pass < 5; ++pass) {
    ApplyCycle(soil, kPass, volume);
    EXPECT_FALSE(CycleIsOpen(volume));
    EXPECT_EQ(volume.preconsolidation_density, volume.density);
    EXPECT_NEAR(volume.preconsolidation_stress, 96e3 * std::pow(10, (volume.density - 1200) / 500),
                1e-6);
  }
  EXPECT_GT(volume.preconsolidation_stress, 1.1 * 96e3);
}

TEST(LoadCycle, IsOpenFromTheFirstCompressionToTheEndOfTheRebound) {
  const Compaction soil = LooseLoam();
  SoilVolume volume = UndisturbedVolume(soil);
  Advance(soil, 90e3, 0.01, volume);
  EXPECT_FALSE(CycleIsOpen(volume));
  Advance(soil, 200e3, 0.01, volume);
  EXPECT_TRUE(CycleIsOpen(volume));
  Advance(soil, 1, 0.01, volume);
  EXPECT_TRUE(CycleIsOpen(volume));
  Advance(soil, 0, 1e-4, volume);
  EXPECT_TRUE(CycleIsOpen(volume));
  for (int i = 0; i < 20; ++i) Advance(soil, 0, 0.01, volume);
  EXPECT_FALSE(CycleIsOpen(volume));
}

TEST(LoadCycle, CompactsLessEveryTimeItIsRepeated) {
  const Compaction soil = LooseLoam();
  SoilVolume volume = UndisturbedVolume(soil);
  double last_gain = 1e9;
  for (int pass = 0; pass < 5; ++pass) {
    const double before = volume.density;
    ApplyCycle(soil, kPass, volume);
    EXPECT_GT(volume.density - before, 0);
    EXPECT_LT(volume.density - before, last_gain);
    last_gain = volume.density - before;
  }
}

TEST(LoadCycle, OfMoistSoilMovesTheVirginCurveOnce) {
  Compaction moist = LooseLoam();
  moist.moisture_shift = 25;  // denser at the same stress, so it yields earlier
  const double yield = 96e3 * std::pow(10, -25.0 / 500);
  SoilVolume volume = UndisturbedVolume(moist);
  EXPECT_NEAR(volume.preconsolidation_stress, yield, 1e-6);
  EXPECT_NEAR(TargetDensity(moist, volume, 300e3), 1225 + 500 * std::log10(300.0 / 96), 1e-9);
  for (int pass = 0; pass < 3; ++pass) {
    ApplyCycle(moist, kPass, volume);
    EXPECT_NEAR(TargetDensity(moist, volume, 300e3), 1225 + 500 * std::log10(300.0 / 96), 1e-9);
  }
}

// The shift alone: nothing but the position of the curve changes.
TEST(LoadCycle, OfMoistSoilIsThatOfDrySoilOnAMovedCurve) {
  Compaction moist = LooseLoam(), dry = LooseLoam();
  moist.moisture_shift = 25;
  dry.reference_density += 25;
  SoilVolume a = UndisturbedVolume(moist), b = UndisturbedVolume(dry);
  for (int pass = 0; pass < 3; ++pass) {
    ApplyCycle(moist, kPass, a);
    ApplyCycle(dry, kPass, b);
    EXPECT_DOUBLE_EQ(a.density, b.density);
  }
  EXPECT_GT(a.density, 1210);
}

double GainWithStep(double step) {
  const Compaction soil = LooseLoam();
  SoilVolume volume = UndisturbedVolume(soil);
  for (int pass = 0; pass < 3; ++pass) ApplyCycle(soil, {300e3, 0.2, step}, volume);
  return volume.density - soil.initial_density;
}

// What is left is what each of the three cycles may leave of its rebound.
TEST(LoadCycle, CompactsTheSameWithAnyStep) {
  for (double step : {2e-3, 1e-3, 1e-4}) {
    EXPECT_NEAR(GainWithStep(step), GainWithStep(1e-5), 3 * kReboundDue);
  }
}

}  // namespace
}  // namespace softsoil
