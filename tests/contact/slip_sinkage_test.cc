// A wheel that slips works its way down, by the shear history of each node.
#include <gtest/gtest.h>

#include "tests/contact/soil_bin.h"

namespace softsoil {
namespace {

SoilBinSettings Settings(double slip_sinkage) {
  SoilBinSettings settings;
  settings.soil.slip_sinkage = slip_sinkage;
  return settings;
}

WheelReport At(double slip, const SoilBinSettings& settings = Settings(0.3)) {
  return SoilBin(settings).Measure(slip);
}

TEST(SlipSinkage, GrowsWithSlip) {
  double last = At(0).sinkage;
  for (const double slip : {0.1, 0.3, 0.8}) {
    const double sinkage = At(slip).sinkage;
    EXPECT_GT(sinkage, last + 0.002) << slip;
    last = sinkage;
  }
}

TEST(SlipSinkage, IsNearlyAbsentUnderAWheelThatRollsAndAbsentInItsSoil) {
  EXPECT_NEAR(At(0).sinkage / At(0, Settings(0)).sinkage, 1, 0.05);
  EXPECT_NEAR(At(0.8, Settings(0)).sinkage / At(0.2, Settings(0)).sinkage, 1, 0.02);
}

TEST(SlipSinkage, CostsPullButNotThrust) {
  const WheelReport sinks = At(0.8), stays = At(0.8, Settings(0));
  EXPECT_GT(sinks.motion_resistance, 1.5 * stays.motion_resistance);
  EXPECT_LT(sinks.drawbar_pull, 0.95 * stays.drawbar_pull);
  EXPECT_NEAR(sinks.thrust / stays.thrust, 1, 0.05);
}

// Where pull no longer grows with slip: an elastic wheel without slip sinkage never has this.
TEST(SlipSinkage, GivesThePullAPeak) {
  const double pull = At(0.3).drawbar_pull;
  EXPECT_GT(pull, At(0.1).drawbar_pull);
  EXPECT_GT(pull, At(0.8).drawbar_pull);
}

TEST(SlipSinkage, DigsInAWheelThatSpinsOnTheSpot) {
  SoilBin bin(Settings(0.3));
  bin.Drive(0.6, 0, 0);
  const double before = bin.pose().centre_w.z();
  bin.Drive(0.5, 0.01, 99);  // 1 m/s at the tread
  const double half = bin.pose().centre_w.z();
  bin.Drive(0.5, 0.01, 99);
  EXPECT_LT(half, before - 0.02);
  EXPECT_LT(bin.pose().centre_w.z(), half - 0.02);
}

TEST(SlipSinkage, DigsInAWheelThatSlidesSideways) {
  const auto sinkage = [](double slip_sinkage) {
    SoilBin bin(Settings(slip_sinkage));
    bin.Drive(0.6, 0, 0);
    bin.pose().velocity_w.y() = 0.5;
    bin.Drive(0.6, 0.5, 0);
    return bin.Drive(0.2, 0.5, 0).sinkage;
  };
  EXPECT_GT(sinkage(0.3), sinkage(0) + 0.005);
}

TEST(SlipSinkage, IsThereForTheNextWheel) {
  const auto second = [](double first_slip, double slip) {
    SoilBin bin(Settings(0.3));
    bin.Measure(first_slip);
    bin.Lift();
    bin.Step();
    bin.PutDownAt(0.3);
    bin.Drive(0.2, 0, 0);
    bin.Drive(0.5, 1, slip);
    return bin.Drive(0.1, 1, slip).sinkage;
  };
  EXPECT_GT(second(0.5, 0), second(0, 0) + 0.01);
  EXPECT_GT(second(0.5, 0.5), second(0.5, 0) + 0.003);
}

TEST(SlipSinkage, DoesNotDependOnTheTimeStep) {
  SoilBinSettings fine = Settings(0.3);
  fine.step = 0.001;
  EXPECT_NEAR(At(0.5, fine).sinkage / At(0.5).sinkage, 1, 0.01);
}

TEST(SlipSinkage, DoesNotDependOnTheGrid) {
  SoilBinSettings fine = Settings(0.3);
  fine.grid_spacing = 0.035;
  EXPECT_NEAR(At(0.5, fine).sinkage / At(0.5).sinkage, 1, 0.05);
}

TEST(SlipSinkage, IsNoneWhereTheSurfaceSinksByCompactionAlone) {
  SoilBinSettings sinks = Settings(0.3), stays = Settings(0);
  sinks.mode = stays.mode = SurfaceMode::kCompaction;
  EXPECT_EQ(At(0.5, sinks).sinkage, At(0.5, stays).sinkage);
}

}  // namespace
}  // namespace softsoil
