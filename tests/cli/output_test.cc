#include <gmock/gmock.h>
#include <unistd.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "plugin/cli/contact_log.h"
#include "plugin/cli/npy.h"
#include "plugin/cli/wheel_columns.h"
#include "plugin/cli/wheel_log.h"
#include "terrain/input_error.h"
#include "terrain/output_file.h"

namespace softsoil {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::ThrowsMessage;

std::string Content(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

// An empty folder for each test: they run in parallel.
class Output : public testing::Test {
 protected:
  Output() { fs::create_directories(folder_); }
  ~Output() override { fs::remove_all(folder_); }
  const std::string folder_ = testing::TempDir() + "output_" + std::to_string(getpid());
  const std::string path_ = folder_ + "/a.txt";
};

TEST_F(Output, HasItsNameOnlyWhenComplete) {
  OutputFile file(path_);
  file.Write("half");
  file.Flush();
  EXPECT_FALSE(fs::exists(path_));
  EXPECT_EQ(Content(path_ + ".part"), "half");
  file.Write(", whole");
  file.Finish();
  EXPECT_EQ(Content(path_), "half, whole");
  EXPECT_FALSE(fs::exists(path_ + ".part"));
}

TEST_F(Output, LeavesNoHalfFileUnderItsName) {
  { OutputFile(path_).Write("half"); }
  EXPECT_FALSE(fs::exists(path_));
}

TEST_F(Output, SaysThatTheDiskIsFull) {
  fs::create_symlink("/dev/full", path_ + ".part");
  const auto write = [this] {
    OutputFile file(path_);
    file.Write("x");
    file.Finish();
  };
  EXPECT_THAT(write, ThrowsMessage<std::runtime_error>(
                         path_ + ".part: cannot write: No space left on device"));
}

TEST_F(Output, SaysThatAFileCannotBeOpened) {
  const std::string path = folder_ + "/nowhere/a.txt";
  EXPECT_THAT(
      [&] { OutputFile file(path); },
      ThrowsMessage<std::runtime_error>(path + ".part: cannot open: No such file or directory"));
}

TEST_F(Output, FolderIsMadeWithItsParents) {
  PrepareFolder(folder_ + "/b/c");
  EXPECT_TRUE(fs::is_directory(folder_ + "/b/c"));
}

TEST_F(Output, FolderThatIsAFileIsRefused) {
  std::ofstream(path_) << "x";
  EXPECT_THAT([&] { PrepareFolder(path_); },
              ThrowsMessage<InputError>(HasSubstr("cannot write into this folder")));
  EXPECT_THAT([&] { PrepareFolder(path_ + "/b"); },
              ThrowsMessage<InputError>(HasSubstr("cannot write into this folder")));
}

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
