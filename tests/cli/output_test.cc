#include <gmock/gmock.h>
#include <unistd.h>

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "plugin/cli/npy.h"
#include "plugin/cli/output_file.h"
#include "plugin/cli/wheel_columns.h"
#include "plugin/cli/wheel_log.h"
#include "terrain/input_error.h"

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
  EXPECT_THAT(text, HasSubstr("slip angle [deg]"));
  EXPECT_THAT(text, HasSubstr("\n0.5,\"left, \"\"big\"\"\",0,0,0,1250,0,0,0,90,0,"));
  EXPECT_THAT(text, HasSubstr("\n0.5,right,0,0,0,1,"));
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
