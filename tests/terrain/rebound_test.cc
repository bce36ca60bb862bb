#include <gtest/gtest.h>

#include <algorithm>

#include "terrain/load_cycle.h"
#include "tests/terrain/test_soil.h"

namespace softsoil {
namespace {

constexpr double kYield = 96e3;  // [Pa]

SoilVolume Compacted(const Compaction& soil, double duration) {
  SoilVolume volume = UndisturbedVolume(soil);
  for (double t = 0; t < duration; t += 1e-3) Advance(soil, 300e3, 1e-3, volume);
  return volume;
}

SoilVolume Unloaded(const Compaction& soil, SoilVolume volume, double stress) {
  for (int i = 0; i < 1000; ++i) Advance(soil, stress, 1e-3, volume);
  return volume;
}

TEST(Rebound, GivesBackHalfOfASmallGain) {
  const Compaction soil = LooseLoam();
  const SoilVolume loaded = Compacted(soil, 0.01);
  const double gain = loaded.density - 1200;
  ASSERT_GT(gain, 0.1);
  ASSERT_LT(gain / 2, soil.rebound_index);
  EXPECT_NEAR(Unloaded(soil, loaded, 50e3).density, loaded.density - gain / 2, 1e-6);
}

TEST(Rebound, GivesBackTheReboundIndexAtMost) {
  const Compaction soil = LooseLoam();
  const SoilVolume loaded = Compacted(soil, 0.5);
  ASSERT_GT((loaded.density - 1200) / 2, soil.rebound_index);
  EXPECT_NEAR(Unloaded(soil, loaded, 50e3).density, loaded.density - soil.rebound_index, 1e-6);
}

TEST(Rebound, TakesTheTimeConstantForSixtyThreePercent) {
  const Compaction soil = LooseLoam();
  SoilVolume volume = Compacted(soil, 0.5);
  const double peak = volume.density;
  for (int i = 0; i < 40; ++i) Advance(soil, 50e3, 1e-4, volume);
  EXPECT_NEAR(peak - volume.density, soil.rebound_index * (1 - std::exp(-1.0)), 1e-9);
}

TEST(Rebound, DoesNotStartAboveThePreconsolidationStress) {
  const Compaction soil = LooseLoam();
  const SoilVolume loaded = Compacted(soil, 0.1);
  EXPECT_EQ(Unloaded(soil, loaded, 1.001 * kYield).density, loaded.density);
  EXPECT_LT(Unloaded(soil, loaded, 0.999 * kYield).density, loaded.density);
}

TEST(Rebound, NeverIncreasesDensity) {
  const Compaction soil = LooseLoam();
  for (double duration : {0.001, 0.01, 0.1, 1.0}) {
    SoilVolume volume = Compacted(soil, duration);
    for (double stress = kYield; stress >= 0; stress -= 1e3) {
      const double before = volume.density;
      Advance(soil, stress, 1e-3, volume);
      EXPECT_LE(volume.density, before);
    }
  }
}

TEST(Rebound, IsSpentOncePerCycleHoweverOftenTheStressFalls) {
  const Compaction soil = LooseLoam();
  SoilVolume volume = Compacted(soil, 0.5);
  const double peak = volume.density;
  for (int i = 0; i < 50; ++i) {
    Advance(soil, 90e3, 0.05, volume);   // springs back
    Advance(soil, 100e3, 0.05, volume);  // neither compacts nor springs back
  }
  EXPECT_NEAR(volume.density, peak - soil.rebound_index, 1e-9);
}

// A load that goes in one step gives back as much as one that is held off, for any time step.
TEST(Rebound, IsTheSameForAnyStepAfterASuddenUnloading) {
  const Compaction soil = LooseLoam();
  for (double step : {1e-2, 1e-3, 1e-4}) {
    SoilVolume volume = Compacted(soil, 0.5);
    const double peak = volume.density;
    while (CycleIsOpen(volume)) Advance(soil, 0, step, volume);
    EXPECT_NEAR(volume.density, peak - soil.rebound_index, kReboundDue);
  }
}

// Columns keep the peak in float: rounded up it may stand above the density.
TEST(Rebound, DoesNotReachForAPeakThatWasRoundedUp) {
  Compaction soil = LooseLoam();
  soil.rebound_index = 0;
  SoilVolume loaded = Compacted(soil, 0.1);
  loaded.peak_density += 1e-4;
  EXPECT_EQ(Unloaded(soil, loaded, 50e3).density, loaded.density);
}

TEST(Rebound, IsAbsentWithoutAReboundIndex) {
  Compaction soil = LooseLoam();
  soil.rebound_index = 0;
  const SoilVolume loaded = Compacted(soil, 0.1);
  EXPECT_EQ(Unloaded(soil, loaded, 50e3).density, loaded.density);
}

}  // namespace
}  // namespace softsoil
