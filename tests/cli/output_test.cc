#include <gmock/gmock.h>

#include <cmath>
#include <cstdint>
#include <cstring>

#include "plugin/cli/contact_log.h"
#include "plugin/cli/npy.h"
#include "plugin/cli/wheel_columns.h"
#include "plugin/cli/wheel_log.h"
#include "tests/terrain/output_folder.h"

namespace softsoil {
namespace {

using testing::HasSubstr;

using Output = OutputFolder;

TEST_F(Output, NpyHasTheLayoutThatNumpyDocuments) {
  const std::vector<float> values = {1, 2, 3, 4, 5, 6};
  WriteNpy(path_, values, 3);
  const std::string text = Content(path_);
  EXPECT_EQ(text.substr(0, 8), std::string("\x93NUMPY\x01\x00", 8));
  const std::size_t length =
      static_cast<std::uint8_t>(text[8]) + 256 * static_cast<std::uint8_t>(text[9]);
  EXPECT_EQ((10 + length) % 64, 0u);
  EXPECT_THAT(text.substr(10, length), HasSubstr("'shape': (2, 3)"));
  EXPECT_EQ(text[9 + length], '\n');
  ASSERT_EQ(text.size(), 10 + length + sizeof(float) * values.size());
  EXPECT_EQ(std::memcmp(text.data() + 10 + length, values.data(), sizeof(float) * 6), 0);
}

softsoilWheel Wheel(const char* name, double load, double slip_angle) {
  softsoilWheel wheel = {};
  wheel.name = name;
  wheel.load = load;
  wheel.slip_angle = slip_angle;
  return wheel;
}

TEST_F(Output, WheelLogHasUnitsDegreesAndQuotedNames) {
  WheelLog log(path_);
  log.Write(0.5, {Wheel("left, \"big\"", 1250, 3.14159265358979 / 2), Wheel("right", 1, 0)});
  log.Finish();
  const std::string text = Content(path_);
  EXPECT_THAT(text, testing::StartsWith("time [s],wheel,x [m],y [m],z [m],load [N],sinkage [m],"));
  EXPECT_THAT(text, HasSubstr("slip_angle [deg]"));
  EXPECT_THAT(text, HasSubstr("\n0.5,\"left, \"\"big\"\"\",0,0,0,1250,0,0,0,90,0,"));
  EXPECT_THAT(text, HasSubstr("\n0.5,right,0,0,0,1,"));
}

// A node 30 degrees ahead of the lowest point of a tire of 0.5 m radius, 0.1 m left of its middle.
TEST_F(Output, ContactLogHasUnitsDegreesAndTheDistanceAhead) {
  softsoilWheel wheel = Wheel("left, \"big\"", 1, 0);
  wheel.centre[2] = 0.4;
  softsoilContact contact = {};
  contact.angle = 3.14159265358979 / 6;
  contact.lateral = 0.1;
  contact.position[0] = -0.1;  // it faces y
  contact.position[1] = 0.25;
  contact.position[2] = 0.4 - 0.5 * std::cos(contact.angle);
  contact.pressure = 7e4;
  contact.shear = -2;
  contact.shear_across = 3;
  contact.area = 0.0006;
  contact.depth = 0.04;
  ContactLog log(path_);
  log.Write(0.5, wheel, {contact});
  log.Write(0.6, wheel, {});
  log.Finish();
  EXPECT_EQ(
      Content(path_),
      "time [s],wheel,x [m],y [m],z [m],angle [deg],ahead [m],lateral [m],pressure [Pa],"
      "shear [Pa],shear_across [Pa],area [m^2],depth [m]\n"
      "0.5,\"left, \"\"big\"\"\",-0.1,0.25,-0.0330127019,30,0.25,0.1,70000,-2,3,0.0006,0.04\n");
}

TEST(WheelMean, IsTheMeanOfForcesAndTheLastOfTotals) {
  softsoilWheel wheel = Wheel("w", 10, 0);
  wheel.compaction_energy = 5;
  WheelMean mean;
  EXPECT_EQ(mean.Value("load"), 0);
  mean.Add(wheel);
  wheel.load = 20;
  wheel.compaction_energy = 8;
  mean.Add(wheel);
  EXPECT_EQ(mean.Value("load"), 15);
  EXPECT_EQ(mean.Value("compaction_energy"), 8);
}

}  // namespace
}  // namespace softsoil
