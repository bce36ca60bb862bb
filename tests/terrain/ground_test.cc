#include "terrain/ground.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "tests/terrain/pressed_ground.h"

namespace softsoil {
namespace {

const Circle kPlate{{0, 0}, 0.2, 250e3};

GroundSettings Settings() {
  GroundSettings settings;
  settings.grid_spacing = 0.05;
  settings.volume_height = 0.05;
  settings.volumes = 24;
  settings.sync = true;
  return settings;
}

// Presses the plate for the time [s] in steps of h.
void Press(Ground& ground, const Circle& plate, double time, double h, int source = 0) {
  const std::vector<SurfaceForce> forces = ForcesOf(plate, ground.settings().grid_spacing);
  for (double t = h / 2; t < time; t += h) {
    ground.AddLoad(source, forces, h);
    ground.Pass(h);
  }
}

double Sinkage(const Ground& ground) { return -ground.surface().NodeHeight({0, 0}); }

TEST(Ground, SinksUnderAPlate) {
  Ground ground(LooseSoil(), Settings(), FlatGround, 1);
  Press(ground, kPlate, 0.5, 0.001);
  EXPECT_GT(Sinkage(ground), 0.02);
  EXPECT_EQ(ground.surface().NodeHeight({40, 0}), 0);
  EXPECT_FALSE(ground.LowestVolumeYields());
}

TEST(Ground, SinksNotBeforeTheFirstTick) {
  Ground ground(LooseSoil(), Settings(), FlatGround, 1);
  Press(ground, kPlate, 0.009, 0.001);
  EXPECT_EQ(Sinkage(ground), 0);
  Press(ground, kPlate, 0.001, 0.001);
  EXPECT_GT(Sinkage(ground), 0);
}

// Heights of the middle at every tick.
std::vector<double> Heights(const GroundSettings& settings, int ticks) {
  Ground ground(LooseSoil(), settings, FlatGround, 1);
  std::vector<double> heights;
  for (int tick = 0; tick < ticks; ++tick) {
    const double pressure = tick % 10 < 7 ? 250e3 : 0;
    Press(ground, {{tick / 8, 0}, 0.2, pressure}, 0.01, 0.001);
    heights.push_back(ground.surface().NodeHeight({0, 0}));
  }
  return heights;
}

TEST(Ground, InTheBackgroundHasTheHeightsOfSyncOnePeriodLater) {
  GroundSettings background = Settings();
  background.sync = false;
  const std::vector<double> now = Heights(Settings(), 60), later = Heights(background, 60);
  EXPECT_EQ(later[0], 0);
  EXPECT_LT(now[0], 0);
  for (std::size_t tick = 1; tick < now.size(); ++tick)
    ASSERT_EQ(later[tick], now[tick - 1]) << tick;
}

TEST(Ground, HasTheSameBitsOnAnyNumberOfThreads) {
  GroundSettings two = Settings();
  two.threads = 2;
  two.sync = false;
  GroundSettings one = two;
  one.threads = 1;
  EXPECT_EQ(Heights(one, 30), Heights(two, 30));
}

TEST(Ground, SinksTheSameWhenTheStepDoesNotDivideThePeriod) {
  Ground even(LooseSoil(), Settings(), FlatGround, 1), odd(LooseSoil(), Settings(), FlatGround, 1);
  Press(even, kPlate, 0.63, 0.001);
  Press(odd, kPlate, 0.63, 0.003);
  EXPECT_NEAR(Sinkage(odd) / Sinkage(even), 1, 0.01);
}

TEST(Ground, CarriesTheMeanOfALoadThatComesAndGoes) {
  Ground steady(LooseSoil(), Settings(), FlatGround, 1),
      jumpy(LooseSoil(), Settings(), FlatGround, 1);
  for (int step = 0; step < 300; ++step) {
    steady.AddLoad(0, ForcesOf({{0, 0}, 0.2, 250e3}, 0.05), 0.001);
    jumpy.AddLoad(0, ForcesOf({{0, 0}, 0.2, step % 2 == 0 ? 500e3 : 0}, 0.05), 0.001);
    steady.Pass(0.001);
    jumpy.Pass(0.001);
  }
  EXPECT_GT(Sinkage(steady), 0.01);
  EXPECT_NEAR(Sinkage(jumpy), Sinkage(steady), 1e-6);
}

TEST(Ground, TellsTheWorkOfEverySource) {
  Ground ground(LooseSoil(), Settings(), FlatGround, 3),
      alone(LooseSoil(), Settings(), FlatGround, 1);
  const Circle far{{400, 0}, 0.2, 350e3};
  double energy_before_last = 0;
  for (int tick = 0; tick < 20; ++tick) {
    energy_before_last = ground.Work(0).energy;
    ground.AddLoad(0, ForcesOf(kPlate, 0.05), 0.01);
    ground.AddLoad(2, ForcesOf(far, 0.05), 0.01);
    ground.Pass(0.01);
  }
  Press(alone, far, 0.2, 0.01);
  EXPECT_GT(ground.Work(0).energy, 0);
  EXPECT_EQ(ground.Work(1).energy, 0);
  EXPECT_NEAR(ground.Work(2).energy / alone.Work(0).energy, 1, 1e-6);
  EXPECT_GT(ground.Work(2).energy, ground.Work(0).energy);
  EXPECT_NEAR(ground.Work(0).power, (ground.Work(0).energy - energy_before_last) / 0.01, 1e-6);
}

TEST(Ground, CompactsWithNoMoreEnergyThanThePlateBrings) {
  Ground ground(LooseSoil(), Settings(), FlatGround, 1);
  Press(ground, kPlate, 0.3, 0.01);
  EXPECT_GT(ground.Work(0).energy, 0);
  EXPECT_LT(ground.Work(0).energy, 1.5 * kPlate.pressure * ground.surface().RutVolume());
}

TEST(Ground, HasNoPowerOnceTheLoadIsGone) {
  Ground ground(LooseSoil(), Settings(), FlatGround, 1);
  Press(ground, kPlate, 0.05, 0.01);
  const double energy = ground.Work(0).energy;
  ground.Pass(0.01);
  EXPECT_EQ(ground.Work(0).power, 0);
  EXPECT_EQ(ground.Work(0).energy, energy);
}

TEST(Ground, TellsThatItsColumnsAreTooShort) {
  GroundSettings settings = Settings();
  settings.volumes = 4;
  Ground ground(LooseSoil(), settings, FlatGround, 1);
  Press(ground, kPlate, 0.1, 0.01);
  EXPECT_TRUE(ground.LowestVolumeYields());
}

TEST(Ground, CostsNothingUntouched) {
  Ground ground(LooseSoil(), Settings(), FlatGround, 1);
  for (int i = 0; i < 100; ++i) ground.Pass(0.001);
  EXPECT_EQ(ground.ColumnBytes(), 0u);
}

TEST(Ground, TakesAtMost24BytesPerVolumeAnd200PerColumn) {
  Ground ground(LooseSoil(), Settings(), FlatGround, 1);
  Press(ground, kPlate, 0.02, 0.01);
  const std::size_t beside = ground.ColumnBytes() - ground.VolumeBytes();
  RecordProperty("bytes_per_volume", ground.VolumeBytes() / ground.VolumeCount());
  RecordProperty("bytes_per_column", beside / ground.ColumnCount());
  ASSERT_GT(ground.ColumnCount(), 0u);
  EXPECT_LE(ground.VolumeBytes(), 24 * ground.VolumeCount());
  EXPECT_LE(beside, 200 * ground.ColumnCount());
}

TEST(Ground, InFlowYieldsToBearingAtOnce) {
  Ground ground(LooseSoil(), Settings(), FlatGround, 1);
  ground.DeepenPlastic(0, {{{0, 0}, 0.03}});
  EXPECT_EQ(Sinkage(ground), 0.03);
}

// Soil above the wheel's foot is displaced and feels nothing; that below compacts as ever.
TEST(Ground, InFlowCompactsBelowASunkWheel) {
  Ground sunk(LooseSoil(), Settings(), FlatGround, 1),
      level(LooseSoil(), Settings(), FlatGround, 1);
  ForEachNodeIn(kPlate, 0.05, [&](GridNode node) { sunk.DeepenPlastic(0, {{node, 0.12}}); });
  Press(sunk, kPlate, 0.3, 0.01);
  Press(level, kPlate, 0.3, 0.01);
  const auto compaction = [](const Ground& ground) { return ground.surface().CompactionVolume(); };
  EXPECT_GT(compaction(level), 0);
  EXPECT_NEAR(compaction(sunk) / compaction(level), 1, 0.2);
}

std::string Refusal(const GroundSettings& settings) {
  try {
    const Ground ground(LooseSoil(), settings, FlatGround, 1);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

template <class Value>
std::string RefusalOf(Value GroundSettings::*setting, Value value) {
  GroundSettings settings = Settings();
  settings.*setting = value;
  return Refusal(settings);
}

TEST(Ground, RefusesSettingsOutOfRange) {
  const double nan = std::nan("");
  EXPECT_EQ(RefusalOf(&GroundSettings::grid_spacing, 0.0),
            "grid_spacing must be 0.001 to 10 m, got 0");
  EXPECT_EQ(RefusalOf(&GroundSettings::grid_spacing, nan),
            "grid_spacing must be 0.001 to 10 m, got nan");
  EXPECT_EQ(RefusalOf(&GroundSettings::volume_height, -0.025),
            "volume_height must be 0.001 to 10 m, got -0.025");
  EXPECT_EQ(RefusalOf(&GroundSettings::volumes, 0), "volumes must be 1 to 1000, got 0");
  EXPECT_EQ(RefusalOf(&GroundSettings::soil_clock, nan),
            "soil_clock must be 0.0001 to 10 s, got nan");
  EXPECT_EQ(RefusalOf(&GroundSettings::threads, 0), "threads must be 1 to 1024, got 0");
  EXPECT_EQ(Refusal(Settings()), "");
}

}  // namespace
}  // namespace softsoil
