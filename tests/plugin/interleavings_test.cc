// Whatever a host does with several mjData, each goes on to the bit as a mjData that has only
// stepped with the same controls since its reset.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "tests/plugin/plain_runs.h"

namespace softsoil {
namespace {

struct FreeSnapshot {
  void operator()(softsoilSnapshot* snapshot) const { softsoil_free_snapshot(snapshot); }
};

enum class By { kApi, kMarks, kBoth };

// Acts on three mjData at random.
class Interleaving {
 public:
  Interleaving(PlainRuns* plain, By by, unsigned seed)
      : plain_(*plain), m_(plain->m.get()), by_(by), random_(seed) {
    for (Run& run : runs_) run.d = plain_.Make();
    for (Saved& saved : saved_) saved.d = MakeData(plain_.m);
  }

  void Act() {
    Run& run = runs_[Below(3)];
    switch (Below(12)) {
      case 0: Copy(run, runs_[Below(3)]); break;
      case 1: Save(run, saved_[Below(2)]); break;
      case 2: Restore(run, saved_[Below(2)]); break;
      case 3: TakeDifferences(run); break;
      case 4: ThroughFile(run, runs_[Below(3)]); break;
      case 5: Try(run); break;
      case 6:
        if (Below(3) == 0) Reset(run);
        break;
      case 7: Check(run); break;
      default: Step(run);
    }
  }

  void CheckAll() {
    for (Run& run : runs_) Check(run);
  }
  const std::string& story() const { return story_; }

 private:
  struct Run {
    Data d;
    Controls controls;  // since the last reset
  };
  struct Saved {
    Data d;
    std::unique_ptr<softsoilSnapshot, FreeSnapshot> soil;
    Controls controls;
    bool is_used = false;
  };

  // By hand: distributions differ between libraries.
  int Below(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }
  void Note(const Run& run, const char* what) {
    story_ += " " + std::to_string(&run - runs_) + ":" + what;
  }
  // In either order; without the API mj_function() alone.
  template <class Mujoco, class Soil>
  void Both(const Mujoco& mj_function, const Soil& soil_function) {
    const bool by_soil = by_ == By::kApi || (by_ == By::kBoth && Below(2) == 0);
    const bool soil_first = by_soil && Below(2) == 0;
    story_ += by_soil ? soil_first ? "(soil first)" : "(soil last)" : "";
    if (!soil_first) mj_function();
    if (by_soil) {
      EXPECT_EQ(soil_function(), 0) << softsoil_error();
    }
    if (soil_first) mj_function();
  }

  void Step(Run& run) {
    const int control = Below(kControls);
    for (int n = 1 + Below(4); n > 0; --n) {
      Note(run, "step");
      plain_.Step(run.d.get(), control);
      run.controls.push_back(control);
    }
  }

  void Copy(Run& to, const Run& from) {
    if (&to == &from) return;
    Note(to, "copy");
    Both([&] { mj_copyData(to.d.get(), m_, from.d.get()); },
         [&] { return softsoil_copy(to.d.get(), from.d.get()); });
    to.controls = from.controls;
  }

  void Save(const Run& run, Saved& saved) {
    Note(run, "save");
    mj_copyData(saved.d.get(), m_, run.d.get());
    if (by_ != By::kMarks) {
      saved.soil.reset(softsoil_snapshot(run.d.get()));
      EXPECT_NE(saved.soil, nullptr) << softsoil_error();
    }
    saved.controls = run.controls;
    saved.is_used = true;
  }

  void Restore(Run& run, const Saved& saved) {
    if (!saved.is_used) return;
    Note(run, "restore");
    Both([&] { mj_copyData(run.d.get(), m_, saved.d.get()); },
         [&] { return softsoil_restore(run.d.get(), saved.soil.get()); });
    run.controls = saved.controls;
  }

  void ThroughFile(Run& to, const Run& from) {
    if (by_ == By::kMarks || Below(3) > 0) return;
    Note(to, "file");
    const std::string path =
        testing::TempDir() + "softsoil_interleavings_" + std::to_string(getpid());
    EXPECT_EQ(softsoil_save_simulation(m_, from.d.get(), path.c_str()), 0) << softsoil_error();
    EXPECT_EQ(softsoil_load_simulation(m_, to.d.get(), path.c_str()), 0) << softsoil_error();
    std::remove(path.c_str());
    to.controls = from.controls;
  }

  void Reset(Run& run) {
    Note(run, "reset");
    Both([&] { mj_resetData(m_, run.d.get()); }, [&] { return softsoil_reset(m_, run.d.get()); });
    run.controls.clear();
  }

  void Try(Run& run) {
    Note(run, "try");
    for (int n = 1 + Below(3); n > 0; --n) mj_forward(m_, run.d.get());
    if (Below(2) == 0) mj_inverse(m_, run.d.get());
  }

  void TakeDifferences(Run& run) {
    Note(run, "differences");
    const int n = 2 * m_->nv;
    Numbers a(n * n), b(n * m_->nu);
    const double time = run.d->time;
    const auto centred = static_cast<mjtByte>(Below(2));
    mjd_transitionFD(m_, run.d.get(), 1e-6, centred, a.data(), b.data(), nullptr, nullptr);
    run.d->time = time;
  }

  void Check(Run& run) {
    Note(run, "check");
    EXPECT_TRUE(plain_.Ask(run.d.get()) == plain_.Run(run.controls)) << "run " << &run - runs_;
  }

  PlainRuns& plain_;
  const mjModel* m_;
  const By by_;
  std::mt19937 random_;
  Run runs_[3];
  Saved saved_[2];
  std::string story_;
};

// Returns whether all went well.
bool HoldsFor(PlainRuns* plain, By by, unsigned seed) {
  Interleaving interleaving(plain, by, seed);
  for (unsigned i = 0; i < 20 + seed % 21; ++i) {
    interleaving.Act();
    if (testing::Test::HasFailure()) break;
  }
  if (!testing::Test::HasFailure()) interleaving.CheckAll();
  if (!testing::Test::HasFailure()) return true;
  ADD_FAILURE() << "seed " << seed << ":" << interleaving.story();
  return false;
}

void ExpectPlainRuns(By by, unsigned first_seed, unsigned count) {
  const int nuserdata = by == By::kApi ? 0 : 2;
  unsigned seed = first_seed;
  for (const char* integrator : {"Euler", "RK4"}) {
    for (const bool sync : {false, true}) {
      PlainRuns plain(TwoMotors(integrator, sync, nuserdata));
      for (unsigned i = 0; i < count / 4; ++i) {
        if (!HoldsFor(&plain, by, seed++)) return;
      }
    }
  }
}

TEST(Interleavings, WithTheApiAreAsPlainRuns) { ExpectPlainRuns(By::kApi, 0, 500); }

TEST(Interleavings, WithMarksAreAsPlainRuns) { ExpectPlainRuns(By::kMarks, 1000, 300); }

TEST(Interleavings, WithMarksAndTheApiAreAsPlainRuns) { ExpectPlainRuns(By::kBoth, 2000, 200); }

TEST(Interleavings, HaveARutAndAForceToCompare) {
  PlainRuns plain(TwoMotors("Euler", true, 0));
  const Data d = plain.Make();
  for (int i = 0; i < 40; ++i) plain.Step(d.get(), i % kControls);
  softsoilGround ground = {};
  ASSERT_EQ(softsoil_ground(d.get(), &ground), 0) << softsoil_error();
  EXPECT_GT(ground.rut_volume, 1e-4);
  EXPECT_GT(ground.densified_volume, 0.01 * ground.displaced_volume) << "part of it is compaction";
  EXPECT_NE(plain.Run({0, 1}).numbers, plain.Run({1, 0}).numbers);
  EXPECT_NE(plain.Run({0, 1}).hash, plain.Run({1, 0}).hash);
}

}  // namespace
}  // namespace softsoil
