// State files that are damaged or of another soil: each is refused, and told why; nothing changes.
#include <gmock/gmock.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "tests/faults/driven_wheel.h"

namespace softsoil {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::AnyOf;
using testing::HasSubstr;
using testing::StartsWith;

class StateFile : public testing::Test {
 protected:
  StateFile() { fs::create_directories(folder_); }
  ~StateFile() override { fs::remove_all(folder_); }

  std::string Contents() const {
    std::ifstream file(path_, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  void Write(const std::string& contents) const {
    std::ofstream(path_, std::ios::binary) << contents;
  }

  const std::string folder_ = testing::TempDir() + "state_file_" + std::to_string(getpid());
  const std::string path_ = folder_ + "/soil.state";
};

// What softsoil_load_simulation() says; neither the soil nor the mjData may change.
std::string Refusal(DrivenWheel& wheel, const std::string& path) {
  const std::uint64_t hash = HashOf(wheel.d.get());
  const double time = wheel.d->time, x = wheel.d->qpos[0];
  if (softsoil_load_simulation(wheel.m.get(), wheel.d.get(), path.c_str()) == 0) return "";
  const std::string said = softsoil_error();
  EXPECT_EQ(HashOf(wheel.d.get()), hash);
  EXPECT_EQ(wheel.d->time, time);
  EXPECT_EQ(wheel.d->qpos[0], x);
  return said;
}

class DamagedStateFile : public StateFile {
 protected:
  DamagedStateFile() {
    EXPECT_EQ(softsoil_save_simulation(wheel_.m.get(), wheel_.d.get(), path_.c_str()), 0);
    sound_ = Contents();
    wheel_.Run(0.01);
  }
  // About a thousand places: all of the head and the tail, and samples between.
  template <class Visit>
  void ForPlaces(const Visit& visit) {
    const std::size_t stride = std::max<std::size_t>(1, sound_.size() / 600);
    for (std::size_t k = 0; k < sound_.size();
         k += k < 200 || k + 200 > sound_.size() ? 1 : stride) {
      visit(k);
    }
  }

  DrivenWheel wheel_;
  std::string sound_;
};

TEST_F(DamagedStateFile, IsSoundBefore) { EXPECT_EQ(Refusal(wheel_, path_), ""); }

TEST_F(DamagedStateFile, ThatEndsTooEarlyIsRefused) {
  ForPlaces([&](std::size_t length) {
    Write(sound_.substr(0, length));
    EXPECT_THAT(Refusal(wheel_, path_),
                AllOf(StartsWith(path_ + ": "),
                      AnyOf(HasSubstr("is no file of softsoil_save()"), HasSubstr("is damaged"))))
        << length;
  });
}

TEST_F(DamagedStateFile, WithABitThatFlippedIsRefused) {
  ForPlaces([&](std::size_t place) {
    std::string damaged = sound_;
    damaged[place] = static_cast<char>(damaged[place] ^ (1 << place % 8));
    Write(damaged);
    EXPECT_THAT(
        Refusal(wheel_, path_),
        AllOf(StartsWith(path_ + ": "), AnyOf(HasSubstr("is no file of softsoil_save()"),
                                              HasSubstr("is damaged"), HasSubstr("has version "))))
        << place;
  });
}

TEST_F(DamagedStateFile, WithMoreBytesIsRefused) {
  Write(sound_ + "12345678");
  EXPECT_THAT(Refusal(wheel_, path_), HasSubstr("is damaged: its checksum is wrong"));
}

TEST_F(DamagedStateFile, ThatIsNotThereIsRefused) {
  fs::rename(path_, path_ + ".renamed");
  EXPECT_EQ(Refusal(wheel_, path_), path_ + ": cannot read: No such file or directory");
  EXPECT_EQ(Refusal(wheel_, folder_), folder_ + ": is a folder");
  EXPECT_EQ(Refusal(wheel_, path_ + ".renamed"), "");
}

TEST_F(DamagedStateFile, ThatIsAPipeIsRefusedAtOnce) {
  const std::string pipe = folder_ + "/pipe";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_EQ(Refusal(wheel_, pipe), pipe + ": is not a regular file");
}

TEST_F(DamagedStateFile, ThatIsAnotherFileMayBeLargerThanTheMemory) {
  Write("no state");
  fs::resize_file(path_, std::uintmax_t{1} << 40);  // a hole
  EXPECT_EQ(Refusal(wheel_, path_), path_ + ": is no file of softsoil_save()");
}

TEST_F(StateFile, NeedsTheModelOfTheMjData) {
  DrivenWheel wheel;
  const Model other = Load(WheelOnLooseSoil(4).Mjcf());
  const char* const told = "this mjData has no soil for this mjModel: call softsoil_attach() first";
  EXPECT_EQ(softsoil_save_simulation(other.get(), wheel.d.get(), path_.c_str()), -1);
  EXPECT_STREQ(softsoil_error(), told);
  EXPECT_FALSE(fs::exists(path_));
  EXPECT_EQ(softsoil_save_simulation(wheel.m.get(), wheel.d.get(), path_.c_str()), 0);
  EXPECT_EQ(softsoil_load_simulation(other.get(), wheel.d.get(), path_.c_str()), -1);
  EXPECT_STREQ(softsoil_error(), told);
}

TEST_F(StateFile, NeedsAName) {
  DrivenWheel wheel;
  EXPECT_EQ(softsoil_save(wheel.d.get(), ""), -1);
  EXPECT_STREQ(softsoil_error(), "path must not be empty");
  EXPECT_EQ(softsoil_load(wheel.d.get(), ""), -1);
  EXPECT_STREQ(softsoil_error(), "path must not be empty");
}

// A wheel like the one that is saved, but for one thing.
struct Other {
  const char *in_model, *instead;  // of the MJCF; none
  const char* settings;
  const char* told;
};

class StateFileOfAnotherSoil : public StateFile, public testing::WithParamInterface<Other> {};

TEST_P(StateFileOfAnotherSoil, IsRefusedByName) {
  DrivenWheel wheel;
  ASSERT_EQ(softsoil_save_simulation(wheel.m.get(), wheel.d.get(), path_.c_str()), 0);
  OneWheel model = WheelOnLooseSoil();
  std::string mjcf = model.Mjcf();
  for (std::string from = GetParam().in_model; !from.empty();) {
    const std::size_t at = mjcf.find(from);
    if (at == std::string::npos) break;
    mjcf.replace(at, from.size(), GetParam().instead);
  }
  const Model m = Load(mjcf);
  const Data d = MakeData(m);
  ASSERT_EQ(softsoil_attach(m.get(), d.get(), GetParam().settings), 0) << softsoil_error();
  EXPECT_EQ(softsoil_load_simulation(m.get(), d.get(), path_.c_str()), -1);
  EXPECT_EQ(softsoil_error(), path_ + ": " + GetParam().told);
}

INSTANTIATE_TEST_SUITE_P(
    OfEveryKind, StateFileOfAnotherSoil,
    testing::Values(
        Other{"", "", "soil=tilled_yolo_loam",
              "the state is of another soil: soil is tilled_yolo_loam here, there "
              "upland_sandy_loam"},
        Other{"", "", "grid_spacing=0.05",
              "the state is of another soil: grid_spacing is 0.05 here, there 0.1"},
        Other{"", "", "volumes=6", "the state is of another soil: volumes is 6 here, there 5"},
        Other{"", "", "clock=0.02", "the state is of another soil: clock is 0.02 here, there 0.01"},
        Other{"", "", "mode=compaction",
              "the state is of another soil: mode is compaction here, there flow"},
        Other{"", "", "bumps=0.02,1,3",
              "the state is of another soil: bumps is 0.02,1,3 here, there none"},
        Other{"", "", "tire=18.4R38@85kPa",
              "the state is of another soil: tire of \"wheel\" is 18.4R38@85kPa here, there auto"},
        Other{"body name=\"wheel\"", "body name=\"roller\"", "",
              "the state is of another soil: tire of \"roller\" is auto here, there tire of "
              "\"wheel\" is auto"},
        Other{"name=\"spin\"", "name=\"roll\"", "",
              "the state is of another model: the names in it differ"}));

class StateFileThatCannotBeWritten : public StateFile {
 protected:
  StateFileThatCannotBeWritten() {
    EXPECT_EQ(softsoil_save(wheel_.d.get(), path_.c_str()), 0);
    old_ = Contents();
    wheel_.Run(0.01);
  }
  // The old file stays, no half one is left, and the soil goes on.
  void ExpectRefusal(const std::string& path, const std::string& told) {
    const std::uint64_t hash = HashOf(wheel_.d.get());
    EXPECT_EQ(softsoil_save(wheel_.d.get(), path.c_str()), -1);
    EXPECT_EQ(softsoil_error(), told);
    EXPECT_EQ(Contents(), old_);
    EXPECT_FALSE(fs::exists(fs::symlink_status(path + ".part")));
    EXPECT_EQ(HashOf(wheel_.d.get()), hash);
    EXPECT_EQ(softsoil_save(wheel_.d.get(), path_.c_str()), 0) << softsoil_error();
  }

  DrivenWheel wheel_;
  std::string old_;
};

TEST_F(StateFileThatCannotBeWritten, ForTheDiskIsFull) {
  fs::create_symlink("/dev/full", path_ + ".part");
  ExpectRefusal(path_, path_ + ".part: cannot write: No space left on device");
}

TEST_F(StateFileThatCannotBeWritten, ForFilesMayNotBeSoLarge) {
  std::signal(SIGXFSZ, SIG_IGN);  // the default ends the program
  rlimit before;
  getrlimit(RLIMIT_FSIZE, &before);
  const rlimit small = {4096, before.rlim_max};
  const std::uint64_t hash = HashOf(wheel_.d.get());
  setrlimit(RLIMIT_FSIZE, &small);
  const int saved = softsoil_save(wheel_.d.get(), path_.c_str());
  setrlimit(RLIMIT_FSIZE, &before);
  EXPECT_EQ(saved, -1);
  EXPECT_EQ(softsoil_error(), path_ + ".part: cannot write: File too large");
  EXPECT_EQ(Contents(), old_);
  EXPECT_FALSE(fs::exists(path_ + ".part"));
  EXPECT_EQ(HashOf(wheel_.d.get()), hash);
}

TEST_F(StateFileThatCannotBeWritten, ForItsFolderIsNotThere) {
  const std::string path = folder_ + "/none/soil.state";
  ExpectRefusal(path, path + ".part: cannot open: No such file or directory");
}

TEST_F(StateFileThatCannotBeWritten, ForItIsAFolder) {
  ExpectRefusal(folder_, folder_ + ": is a folder");
}

TEST_F(StateFileThatCannotBeWritten, ForItsFolderIsLocked) {
  constexpr uid_t kNobody = 65534;
  const uid_t user = geteuid();
  fs::permissions(folder_, fs::perms(0555));
  ASSERT_EQ(seteuid(user == 0 ? kNobody : user), 0);  // root may write anywhere
  EXPECT_EQ(softsoil_save(wheel_.d.get(), path_.c_str()), -1);
  ASSERT_EQ(seteuid(user), 0);
  EXPECT_EQ(softsoil_error(), path_ + ".part: cannot open: Permission denied");
  EXPECT_EQ(Contents(), old_);
  fs::permissions(folder_, fs::perms::owner_all);
}

}  // namespace
}  // namespace softsoil
