// Five seconds of a vehicle on soil that compacts, down to one number: the same for any number of
// threads, in every build type, under gcc and clang, and however busy the machine is.
//
// The number depends, besides on softsoil and the models that it drives on, on MuJoCo 2.2.2 and on
// the last bits of pow() and its like in libm: glibc 2.36 of Debian 12, which takes them by fused
// multiply-add where the processor has it. If this test fails and softsoil was meant to change, or
// libm is another one, put the hash that it reports in the place of kGolden; if neither, bits have
// come to depend on what they must not.
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <thread>
#include <vector>

#include "plugin/softsoil.h"
#include "tests/plugin/mjcf.h"

namespace softsoil {
namespace {

constexpr std::uint64_t kGolden = 9967365323816270389u;

constexpr char kScene[] = SOFTSOIL_SOURCE_DIR "/models/scenes/hmmwv_flat.xml";
constexpr char kSettings[] = "soil_file=" SOFTSOIL_SOURCE_DIR
                             "/tests/golden/loose_loam.xml soil=loose_loam bumps=0.03,1.5,7 "
                             "grid_spacing=0.1 volume_height=0.08 volumes=15 threads=";

double Ramp(double time, double start, double end) {
  return std::fmin(std::fmax((time - start) / (end - start), 0), 1);
}

// Starts, and turns left and right.
void Control(const mjModel* m, mjData* d) {
  const auto actuator = [&](const char* name) { return mj_name2id(m, mjOBJ_ACTUATOR, name); };
  d->ctrl[actuator("drive")] = 4000 * Ramp(d->time, 0.2, 0.6);
  d->ctrl[actuator("steer")] = 0.3 * Ramp(d->time, 1, 1.5) - 0.5 * Ramp(d->time, 2.5, 3.5);
}

struct Drive {
  std::uint64_t hash = 0;
  softsoilGround ground = {};
  double energy = 0;  // [J]
};

Drive FiveSeconds(int threads) {
  char error[500] = "";
  const Model m(mj_loadXML(kScene, nullptr, error, sizeof error));
  EXPECT_NE(m, nullptr) << error;
  const Data d = MakeData(m);
  const std::string settings = kSettings + std::to_string(threads);
  EXPECT_EQ(softsoil_attach(m.get(), d.get(), settings.c_str()), 0) << softsoil_error();
  while (d->time < 5) {
    Control(m.get(), d.get());
    mj_step(m.get(), d.get());
  }
  ExpectNoWarnings(d);
  Drive drive;
  EXPECT_EQ(softsoil_hash(d.get(), &drive.hash), 0) << softsoil_error();
  EXPECT_EQ(softsoil_ground(d.get(), &drive.ground), 0) << softsoil_error();
  softsoilWheel wheel;
  EXPECT_EQ(softsoil_wheel(d.get(), 0, &wheel), 0) << softsoil_error();
  drive.energy = wheel.compaction_energy;
  return drive;
}

// Keeps all processors busy.
class BusyMachine {
 public:
  BusyMachine() {
    for (unsigned i = 0; i < 2 * std::thread::hardware_concurrency(); ++i) {
      threads_.emplace_back([this] {
        while (!ends_) {
        }
      });
    }
  }
  ~BusyMachine() {
    ends_ = true;
    for (std::thread& thread : threads_) thread.join();
  }

 private:
  std::atomic<bool> ends_{false};
  std::vector<std::thread> threads_;
};

TEST(GoldenHash, OfTheHmmwvOnOneThread) {
  const Drive drive = FiveSeconds(1);
  EXPECT_GT(drive.ground.columns, 1000u);
  EXPECT_GT(drive.energy, 100) << "the soil does not compact";
  EXPECT_EQ(drive.hash, kGolden);
}

TEST(GoldenHash, OfTheHmmwvOnTwoThreads) { EXPECT_EQ(FiveSeconds(2).hash, kGolden); }

TEST(GoldenHash, OfTheHmmwvOnABusyMachine) {
  const BusyMachine busy;
  EXPECT_EQ(FiveSeconds(2).hash, kGolden);
}

}  // namespace
}  // namespace softsoil
