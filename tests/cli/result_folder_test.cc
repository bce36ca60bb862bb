#include "plugin/cli/result_folder.h"

#include <gmock/gmock.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <memory>

#include "terrain/input_error.h"

namespace softsoil {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::ThrowsMessage;

// A folder for each test: they run in parallel.
class Results : public testing::Test {
 protected:
  ~Results() override { fs::remove_all(folder_); }
  void Put(const std::string& name) {
    fs::create_directories(folder_);
    std::ofstream(folder_ + "/" + name) << "old";
  }
  const std::string folder_ = testing::TempDir() + "results_" + std::to_string(getpid());
};

TEST_F(Results, OfAnEarlierRunAreTakenAway) {
  Put("wheels.csv");
  Put("notes.txt");
  const ResultFolder results(folder_, {"wheels.csv", "summary.json"});
  EXPECT_FALSE(fs::exists(folder_ + "/wheels.csv"));
  EXPECT_TRUE(fs::exists(folder_ + "/notes.txt"));
}

TEST_F(Results, OfTwoRunsAtOnceDoNotMix) {
  auto first = std::make_unique<ResultFolder>(folder_, std::vector<std::string>{});
  Put("wheels.csv");
  EXPECT_THAT([&] { ResultFolder(folder_, {"wheels.csv"}); },
              ThrowsMessage<InputError>(HasSubstr("another softsoil is writing its results")));
  EXPECT_TRUE(fs::exists(folder_ + "/wheels.csv"));
  first.reset();
  ResultFolder(folder_, {"wheels.csv"});
  EXPECT_FALSE(fs::exists(folder_ + "/wheels.csv"));
}

TEST_F(Results, NeverTakeThePlaceOfAnInput) {
  Put("soil_bin.xml");
  fs::create_symlink("soil_bin.xml", folder_ + "/link.xml");
  const std::string name = fs::path(folder_).filename();
  const std::vector<std::string> spellings = {"/soil_bin.xml", "/../" + name + "/soil_bin.xml",
                                              "/link.xml"};
  for (const std::string& input : spellings) {
    EXPECT_THAT([&] { ResultFolder(folder_, {"soil_bin.xml"}, {folder_ + input}); },
                ThrowsMessage<InputError>(HasSubstr("soil_bin.xml: is an input")));
    EXPECT_TRUE(fs::exists(folder_ + "/soil_bin.xml"));
  }
}

TEST_F(Results, OfARunThatFailsAreTakenAwayWithTheirParts) {
  const ResultFolder results(folder_, {"wheels.csv"});
  Put("wheels.csv");
  Put("wheels.csv.part");
  results.Clear();
  EXPECT_TRUE(fs::is_empty(folder_));
}

TEST_F(Results, CannotReplaceAFolder) {
  fs::create_directories(folder_ + "/wheels.csv/full");
  EXPECT_THAT([&] { ResultFolder(folder_, {"wheels.csv"}); },
              ThrowsMessage<InputError>(HasSubstr("wheels.csv: is a folder, and a result would")));
}

}  // namespace
}  // namespace softsoil
