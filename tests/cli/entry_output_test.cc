// Names and files of the entries that softsoil soil and fit-tire write.
#include "plugin/cli/entry_output.h"

#include <gmock/gmock.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "terrain/input_error.h"

namespace softsoil {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::ThrowsMessage;

TEST(EntryName, HoldsNoLetterThatEndsANameInASetting) {
  EXPECT_NO_THROW(RequireEntryName("my-18.4R38_a+b:c", "tire", {"other"}));
  for (const char* name :
       {"a b", "a\tb", "a\nb", "a\rb", "a\vb", "a\fb", "a,b", "a;b", "a=b", "a@b"}) {
    EXPECT_THAT([&] { RequireEntryName(name, "tire", {}); },
                ThrowsMessage<InputError>("--name must hold no blank, comma, semicolon, = or @, "
                                          "got \"" +
                                          std::string(name) + "\""));
  }
}

TEST(EntryName, IsGivenAndFree) {
  EXPECT_THAT([] { RequireEntryName("", "tire", {}); },
              ThrowsMessage<InputError>("--out needs --name: the name of the tire"));
  EXPECT_THAT(
      [] {
        RequireEntryName("b", "soil", {"a", "b"});
      },
      ThrowsMessage<InputError>("--name b: this name is taken already"));
}

TEST(EntryFiles, StandBesideOneAnother) {
  const auto files = [](const EntryFileOptions& options, bool is_fit) {
    const EntryFiles f = EntryFilesOf(options, is_fit);
    return std::vector<std::string>{f.xml, f.picture, f.json};
  };
  using testing::ElementsAre;
  EXPECT_THAT(files({{}, {}, false}, true), ElementsAre("", "", ""));
  EXPECT_THAT(files({"a/b.xml", {}, false}, true), ElementsAre("a/b.xml", "a/b.png", "a/b.json"));
  EXPECT_THAT(files({"a/b.xml", {}, true}, true), ElementsAre("a/b.xml", "", "a/b.json"));
  EXPECT_THAT(files({"a/b.xml", {}, false}, false), ElementsAre("a/b.xml", "", "a/b.json"));
  EXPECT_THAT(files({"a/b.xml", "c.png", false}, true), ElementsAre("a/b.xml", "c.png", "c.json"));
  EXPECT_THAT(files({{}, "c.png", false}, true), ElementsAre("", "c.png", "c.json"));
}

TEST(EntryFiles, SayByTheirEndingsWhatTheyAre) {
  EXPECT_THAT(
      [] {
        EntryFilesOf({"mine.json", {}, false}, true);
      },
      ThrowsMessage<InputError>("--out must end in .xml, got \"mine.json\""));
  EXPECT_THAT(
      [] {
        EntryFilesOf({{}, "fit.xml", false}, true);
      },
      ThrowsMessage<InputError>("--picture must end in .png, got \"fit.xml\""));
  EXPECT_THAT(
      [] {
        EntryFilesOf({{}, "fit.png", true}, true);
      },
      ThrowsMessage<InputError>("--picture and --no-picture exclude one another"));
}

TEST(EntryNames, AreTextThatXmlAndJsonCanHold) {
  for (const char* name : {"a\x01", "\xff", "a\x7f"}) {
    EXPECT_THAT([&] { RequireEntryName(name, "soil", {}); },
                ThrowsMessage<InputError>("--name must be UTF-8 without control characters"));
  }
  RequireEntryName("Lehm_\xc3\xa4", "soil", {});
}

TEST(EntryFiles, AreOverwrittenOnlyByForce) {
  const std::string folder = testing::TempDir() + "entry_output_" + std::to_string(getpid());
  fs::create_directories(folder);
  const EntryFiles files{folder + "/new/a.xml", folder + "/new/a.png", folder + "/a.json"};
  std::ofstream(files.json) << "mine";
  EXPECT_THAT([&] { PrepareEntryFiles(files, false); },
              ThrowsMessage<InputError>(files.json + ": is there already; --force overwrites it"));
  EXPECT_FALSE(fs::exists(folder + "/new")) << "nothing is made for what is refused";
  EXPECT_THAT(
      [&] {
        PrepareEntryFiles(files, true,
                          {folder + "/../" + fs::path(folder).filename().string() + "/a.json"});
      },
      ThrowsMessage<InputError>(files.json + ": is an input, and a result would take its place"));
  PrepareEntryFiles(files, true);
  EXPECT_TRUE(fs::is_directory(folder + "/new"));
  EXPECT_THAT(
      [&] {
        PrepareEntryFiles({folder, "", ""}, true);
      },
      ThrowsMessage<InputError>(HasSubstr("is a folder, not a file")));
  fs::remove_all(folder);
}

}  // namespace
}  // namespace softsoil
