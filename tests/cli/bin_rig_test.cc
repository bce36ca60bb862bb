#include "plugin/cli/bin_rig.h"

#include <gmock/gmock.h>

#include "plugin/cli/steady_state.h"
#include "terrain/input_error.h"

namespace softsoil {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr double kLoad = 18000;  // [N]

SoilBin Tractor(const std::string& bumps) {
  SoilBin bin;
  bin.tire.name = "18.4R38_85kPa";
  bin.soil = "tilled_yolo_loam";
  bin.tire.shape = {0.91, 0.661, 0.467};
  bin.load = kLoad;
  bin.mode = BinMode::kTorque;
  bin.settings = {{"grid_spacing", "0.1"}, {"volume_height", "0.1"}, {"volumes", "8"}};
  if (!bumps.empty()) bin.settings.emplace_back("bumps", bumps);
  return bin;
}

std::vector<std::string> HighBumps() {
  std::vector<std::string> bumps;
  for (int seed = 0; seed < 8; ++seed) bumps.push_back("5,10," + std::to_string(seed));
  return bumps;
}

// Neither buried in a bump nor above a hollow: within the millimetres that the nodes of the tire,
// the grid and the crown leave.
TEST(BinRig, TouchesTheGroundWhateverItsHeight) {
  double lowest = 0, highest = 0;  // [m]
  for (const std::string& bumps : HighBumps()) {
    const auto rig = MakeRig(Tractor(bumps), 1);
    rig->Step();
    EXPECT_LT(rig->Wheel(0).sinkage, 0.002) << bumps;
    EXPECT_LT(rig->Wheel(0).load, 0.1 * kLoad) << bumps;
    lowest = std::min(lowest, rig->Wheel(0).centre[2] - 0.91);
    highest = std::max(highest, rig->Wheel(0).centre[2] - 0.91);
    while (rig->Wheel(0).load == 0) rig->Step();
    EXPECT_LT(rig->Time(), 0.12) << bumps;  // falls 7 cm
  }
  EXPECT_LT(lowest, -1);
  EXPECT_GT(highest, 1);
}

TEST(BinRig, StandsOnLevelGroundWhereTheSceneHasIt) {
  const auto rig = MakeRig(Tractor(""), 1);
  rig->Step();
  EXPECT_EQ(rig->Wheel(0).centre[2], 0.91);
}

TEST(BinRig, SettlesOnSlopesWithoutRollingDown) {
  for (const std::string& bumps : HighBumps()) {
    const auto rig = MakeRig(Tractor(bumps), 1);
    EXPECT_TRUE(SettleBraked(kLoad, rig.get())) << bumps;
    EXPECT_NEAR(rig->Wheel(0).force[2], kLoad, 0.01 * kLoad) << bumps;
    EXPECT_NEAR(rig->Wheel(0).centre[0], 0, 0.01) << bumps;
  }
}

TEST(BinRig, DoesNotSettleUnderALoadThatIsNotItsOwn) {
  EXPECT_FALSE(Settle(1.5 * kLoad, MakeRig(Tractor(""), 1).get()));
}

TEST(BinRig, IsNotSteadyUnlessItHadSettled) {
  SoilBin bin = Tractor("");
  bin.mode = BinMode::kSlip;
  const BinDrive drive = {1.0, 1.2 / 0.91};
  for (const double load : {kLoad, 1.5 * kLoad}) {
    const auto rig = MakeRig(bin, 1);
    EXPECT_EQ(DriveToSteadyState(drive, bin.tire, load, rig.get()).steady, load == kLoad);
  }
}

// The height 0 of the world means nothing on bumps.
TEST(BinRig, IsNotSunkInAValley) {
  double lowest = 1;  // [m]
  for (const std::string& bumps : HighBumps()) {
    const auto rig = MakeRig(Tractor(bumps), 1);
    for (int step = 0; step < 300; ++step) EXPECT_NO_THROW(StepUnlessSunk(kLoad, rig.get()));
    lowest = std::min(lowest, rig->Wheel(0).centre[2]);
  }
  EXPECT_LT(lowest, -1);
}

TEST(BinRig, IsSunkWhereTheGroundReachesItsAxle) {
  for (const char* bumps : {"", "5,10,1", "5,10,2"}) {
    SoilBin bin = Tractor(bumps);
    bin.load = 1e6;
    const auto rig = MakeRig(bin, 1);
    EXPECT_THAT([&] { SettleBraked(bin.load, rig.get()); },
                ThrowsMessage<InputError>(HasSubstr("the wheel sinks to its axle")))
        << bumps;
  }
}

}  // namespace
}  // namespace softsoil
