#include "terrain/output_file.h"

#include <gmock/gmock.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>

#include "terrain/input_error.h"
#include "tests/terrain/output_folder.h"

namespace softsoil {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::ThrowsMessage;

using OutputFileTest = OutputFolder;

TEST_F(OutputFileTest, HasItsNameOnlyWhenComplete) {
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

TEST_F(OutputFileTest, LeavesNoHalfFileUnderItsName) {
  { OutputFile(path_).Write("half"); }
  EXPECT_FALSE(fs::exists(path_));
}

TEST_F(OutputFileTest, SaysThatTheDiskIsFull) {
  fs::create_symlink("/dev/full", path_ + ".part");
  const auto write = [this] {
    OutputFile file(path_);
    file.Write("x");
    file.Finish();
  };
  EXPECT_THAT(write, ThrowsMessage<std::runtime_error>(
                         path_ + ".part: cannot write: No space left on device"));
}

TEST_F(OutputFileTest, SaysThatAFileCannotBeOpened) {
  const std::string path = folder_ + "/nowhere/a.txt";
  EXPECT_THAT(
      [&] { OutputFile file(path); },
      ThrowsMessage<std::runtime_error>(path + ".part: cannot open: No such file or directory"));
}

TEST_F(OutputFileTest, IsWrittenByOneAtATime) {
  const auto open = [this] { OutputFile file(path_); };
  const auto is_refused =
      ThrowsMessage<std::runtime_error>(path_ + ".part: cannot open: Device or resource busy");
  OutputFile file(path_);
  file.Write("whole");
  EXPECT_THAT(open, is_refused);
  file.Flush();
  EXPECT_THAT(open, is_refused);
  file.Finish();
  EXPECT_EQ(Content(path_), "whole");
  EXPECT_NO_THROW(open());
}

TEST_F(OutputFileTest, DoesNotWaitForTheReaderOfAPipe) {
  ASSERT_EQ(mkfifo((path_ + ".part").c_str(), 0600), 0);
  EXPECT_THAT(
      [this] { OutputFile file(path_); },
      ThrowsMessage<std::runtime_error>(path_ + ".part: cannot open: No such device or address"));
}

TEST_F(OutputFileTest, FolderIsMadeWithItsParents) {
  PrepareFolder(folder_ + "/b/c");
  EXPECT_TRUE(fs::is_directory(folder_ + "/b/c"));
}

TEST_F(OutputFileTest, FolderThatIsAFileIsRefused) {
  std::ofstream(path_) << "x";
  EXPECT_THAT([&] { PrepareFolder(path_); },
              ThrowsMessage<InputError>(HasSubstr("cannot write into this folder")));
  EXPECT_THAT([&] { PrepareFolder(path_ + "/b"); },
              ThrowsMessage<InputError>(HasSubstr("cannot write into this folder")));
}

}  // namespace
}  // namespace softsoil
