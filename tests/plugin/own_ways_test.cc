// MuJoCo's own ways to copy, restore and reset a mjData, of which softsoil is not told.
#include <gmock/gmock.h>
#include <unistd.h>

#include <cstdio>
#include <memory>
#include <string>
#include <utility>

#include "plugin/registry.h"
#include "tests/plugin/compacting_wheel.h"

namespace softsoil {
namespace {

using testing::HasSubstr;

// With marks in userdata and without.
class OwnWays : public testing::TestWithParam<int> {
 protected:
  OneWheel model_ = CompactingWheel(GetParam());
};
INSTANTIATE_TEST_SUITE_P(With, OwnWays, testing::Values(0, 2),
                         [](const auto& info) { return info.param == 0 ? "NoMarks" : "Marks"; });

TEST_P(OwnWays, ResetAsIfNothingHadBeen) {
  const Moment plain = PlainRun(model_, 60);
  for (const int steps : {0, 1, 2, 80}) {
    for (const int resets : {1, 2}) {
      Simulation sim(model_);
      Step(sim, steps);
      for (int i = 0; i < resets; ++i) mj_resetData(sim.m.get(), sim.d.get());
      EXPECT_TRUE(After(60, sim) == plain) << steps << " steps, " << resets << " resets";
    }
  }
}

TEST_P(OwnWays, ResetAfterAMereLook) {
  const Moment plain = PlainRun(model_, 60);
  Simulation sim(model_);
  After(1, sim);
  mj_resetData(sim.m.get(), sim.d.get());
  mj_forward(sim.m.get(), sim.d.get());
  mj_resetData(sim.m.get(), sim.d.get());
  EXPECT_TRUE(After(60, sim) == plain);
}

// Goes to the only keyframe after some steps.
void GoToKey(Simulation& sim, int steps) {
  Step(sim, steps);
  mj_resetDataKeyframe(sim.m.get(), sim.d.get(), 0);
  mj_forward(sim.m.get(), sim.d.get());
}

OneWheel WithKeyAt(const std::string& time, OneWheel model) {
  model.others += "<keyframe><key time=\"" + time + R"(" qpos=".3 -.01 0"/></keyframe>)";
  return model;
}

TEST_P(OwnWays, GoBackToAKeyframeOnUndisturbedGround) {
  for (const char* time : {"0", "0.1"}) {
    const OneWheel model = WithKeyAt(time, model_);
    Simulation sim(model), fresh(model);
    GoToKey(fresh, 0);
    GoToKey(sim, 80);
    EXPECT_TRUE(After(60, sim) == After(60, fresh)) << time;
  }
}

TEST_P(OwnWays, GoAheadToAKeyframeOnUndisturbedGroundIfMarked) {
  const OneWheel model = WithKeyAt("5", model_);
  Simulation sim(model), fresh(model);
  GoToKey(fresh, 0);
  GoToKey(sim, 80);
  EXPECT_EQ(sim.Height() < -0.005, GetParam() == 0);
  EXPECT_EQ(After(60, sim) == After(60, fresh), GetParam() != 0);
}

TEST_P(OwnWays, SetTimeBackByHandAndLoseTheRut) {
  Simulation sim(model_);
  for (const double time : {0.0, 0.1}) {
    Step(sim, 80);
    ASSERT_LT(sim.Height(), -0.005);
    sim.d->time = time;
    mj_forward(sim.m.get(), sim.d.get());
    EXPECT_EQ(sim.Height(), 0);
  }
}

TEST_P(OwnWays, FreeTheSoilWithTheMjData) {
  Simulation sim(model_);
  Step(sim, 50);
  const std::weak_ptr<SoilEntry> entry = Registry::Get().Find(sim.d.get());
  std::weak_ptr<const SoilState> state;
  if (GetParam() != 0) state = SoilHistory::Find(MarkIn(GetParam(), sim.d.get()));
  EXPECT_EQ(state.expired(), GetParam() == 0);
  sim.d.reset();
  EXPECT_TRUE(entry.expired());
  EXPECT_TRUE(state.expired());
}

TEST_P(OwnWays, ReuseAddressesWithoutTheSoilThatWasThere) {
  const Moment plain = PlainRun(model_, 40);
  for (int i = 0; i < 5; ++i) {
    Simulation sim(model_);  // model and mjData where the last ones were
    EXPECT_TRUE(After(40, sim) == plain);
    sim.d = MakeData(sim.m);
    Step(sim, 2);
    EXPECT_EQ(softsoil_wheel_count(sim.d.get()), -1) << "without softsoil_attach()";
    EXPECT_EQ(sim.Row()[2], 0);
  }
}

TEST_P(OwnWays, TakeACopyOfTheModelForTheModel) {
  const Moment plain = PlainRun(model_, 80);
  Simulation sim(model_);
  const Model copy(mj_copyModel(nullptr, sim.m.get()));
  Step(sim, 30);
  Step(copy.get(), sim.d.get(), 30);
  EXPECT_TRUE(After(20, sim) == plain);
}

OneWheel Marked() { return CompactingWheel(2); }

TEST(MarkedMjData, GoesOnAlikeInCopiesWithSoilAndWithout) {
  const Moment plain = PlainRun(Marked(), 80);
  Simulation a(Marked()), used(Marked());
  used.d->qvel[0] = 2;
  Step(used, 30);
  Step(a, 50);
  mj_copyData(used.d.get(), a.m.get(), a.d.get());
  const Data d = CopyOf(a);
  EXPECT_TRUE(After(30, a) == plain);
  EXPECT_TRUE(After(30, used) == plain);
  EXPECT_TRUE(After(30, a.m.get(), d.get()) == plain);
}

TEST(MarkedMjData, GoesOnAlikeInACopyOfTheModel) {
  const Moment plain = PlainRun(Marked(), 80);
  Simulation a(Marked());
  const Model m(mj_copyModel(nullptr, a.m.get()));
  Step(a, 50);
  const Data d = CopyOf(a);
  EXPECT_TRUE(After(30, m.get(), d.get()) == plain);
}

TEST(MarkedMjData, GoesOnAlikeInAChainOfCopiesWhoseSourceIsGone) {
  const Moment plain = PlainRun(Marked(), 80);
  Simulation a(Marked());
  Step(a, 40);
  Data last = CopyOf(a);
  for (int i = 0; i < 10; ++i) {
    Step(a.m.get(), last.get(), 1);
    Data next = MakeData(a.m);
    mj_copyData(next.get(), a.m.get(), last.get());
    mj_forward(a.m.get(), next.get());  // from now on it holds its soil itself
    last = std::move(next);             // the copy that it came from is deleted
  }
  a.d = MakeData(a.m);
  EXPECT_TRUE(After(30, a.m.get(), last.get()) == plain);
}

TEST(MarkedMjData, IsFollowedByQuestionsBeforeTheNextStep) {
  Simulation a(Marked()), b(Marked());
  Step(a, 60);
  ASSERT_LT(a.Height(), -0.005);
  mj_copyData(b.d.get(), b.m.get(), a.d.get());
  EXPECT_EQ(Hash(b.d.get()), Hash(a.d.get()));
  EXPECT_EQ(b.Height(), a.Height());
  EXPECT_EQ(b.Wheel().load, a.Wheel().load);
  const Data c = MakeData(a.m);
  mj_copyData(c.get(), b.m.get(), b.d.get());
  ASSERT_EQ(softsoil_copy(c.get(), b.d.get()), 0) << softsoil_error();
  mj_resetData(b.m.get(), b.d.get());
  EXPECT_EQ(b.Height(), 0);
  EXPECT_TRUE(After(20, a.m.get(), c.get()) == After(20, a));
}

TEST(MarkedMjData, IsSavedAsItIsAfterMjCopyData) {
  const std::string path = testing::TempDir() + "softsoil_own_ways_" + std::to_string(getpid());
  Simulation a(Marked()), b(Marked()), c(Marked());
  Step(a, 60);
  mj_copyData(b.d.get(), b.m.get(), a.d.get());
  ASSERT_EQ(softsoil_save_simulation(b.m.get(), b.d.get(), path.c_str()), 0) << softsoil_error();
  ASSERT_EQ(softsoil_load_simulation(c.m.get(), c.d.get(), path.c_str()), 0) << softsoil_error();
  std::remove(path.c_str());
  EXPECT_TRUE(After(20, c) == After(20, a));
}

TEST(MjDataWithoutMark, IsNotFollowedByTheSoil) {
  Simulation a(CompactingWheel()), b(CompactingWheel());
  Step(a, 60);
  mj_copyData(b.d.get(), b.m.get(), a.d.get());
  mj_forward(b.m.get(), b.d.get());
  EXPECT_LT(a.Height(), -0.005);
  EXPECT_EQ(b.Height(), 0);
}

TEST(Snapshot, OutlivesTheMjDataAndIsNotUsedUp) {
  Simulation a(CompactingWheel()), b(CompactingWheel());
  Step(a, 50);
  const Data saved = CopyOf(a);
  softsoilSnapshot* snapshot = softsoil_snapshot(a.d.get());
  a.d.reset();
  for (int i = 0; i < 2; ++i) {
    mj_copyData(b.d.get(), b.m.get(), saved.get());
    ASSERT_EQ(softsoil_restore(b.d.get(), snapshot), 0) << softsoil_error();
    EXPECT_TRUE(After(30, b) == PlainRun(CompactingWheel(), 80));
  }
  softsoil_free_snapshot(snapshot);
  a.d = MakeData(a.m);
}

TEST(SoftsoilLoad, TakesTheSoilAloneFromAFileWithBoth) {
  const std::string path = testing::TempDir() + "softsoil_soil_alone_" + std::to_string(getpid());
  Simulation a(CompactingWheel()), b(CompactingWheel());
  Step(a, 50);
  ASSERT_EQ(softsoil_save_simulation(a.m.get(), a.d.get(), path.c_str()), 0) << softsoil_error();
  ASSERT_EQ(softsoil_load(b.d.get(), path.c_str()), 0) << softsoil_error();
  std::remove(path.c_str());
  EXPECT_EQ(b.d->time, 0);
  EXPECT_EQ(Hash(b.d.get()), Hash(a.d.get()));
  mj_copyData(b.d.get(), b.m.get(), a.d.get());
  EXPECT_EQ(After(30, b).motion, After(30, a).motion);
}

TEST(SoilOfACopiedModel, IsCopiedWithTheApi) {
  const Moment plain = PlainRun(CompactingWheel(), 80);
  Simulation a(CompactingWheel());
  const Model m(mj_copyModel(nullptr, a.m.get()));
  Step(a, 50);
  const Data attached = MakeData(m), bare = MakeData(m);
  ASSERT_EQ(softsoil_attach(m.get(), attached.get(), nullptr), 0) << softsoil_error();
  for (const Data* d : {&attached, &bare}) {
    mj_copyData(d->get(), m.get(), a.d.get());
    ASSERT_EQ(softsoil_copy(d->get(), a.d.get()), 0) << softsoil_error();
    EXPECT_TRUE(After(30, m.get(), d->get()) == plain);
  }
}

TEST(SoilOfACopiedModel, OutlivesTheModel) {
  Simulation a(CompactingWheel());
  Step(a, 50);
  const Model m(mj_copyModel(nullptr, a.m.get()));
  a.m.reset();
  const Data d = MakeData(m);
  mj_copyData(d.get(), m.get(), a.d.get());
  ASSERT_EQ(softsoil_copy(d.get(), a.d.get()), 0) << softsoil_error();
  EXPECT_TRUE(After(30, m.get(), d.get()) == PlainRun(CompactingWheel(), 80));
}

TEST(SoilOfAnotherModel, IsRefused) {
  Simulation a(CompactingWheel()), coarse(CompactingWheel(), "grid_spacing=0.1");
  Step(a, 10);
  Step(coarse, 10);
  const std::uint64_t before = Hash(coarse.d.get());
  EXPECT_EQ(softsoil_copy(coarse.d.get(), a.d.get()), -1);
  EXPECT_STREQ(softsoil_error(),
               "the state is of another soil: grid_spacing is 0.1 here, there 0.05");
  EXPECT_EQ(Hash(coarse.d.get()), before);
  const Model m = Load(World(R"(<body><freejoint/><geom size=".1"/></body>)"));
  const Data bare = MakeData(m);
  EXPECT_EQ(softsoil_copy(bare.get(), a.d.get()), -1);
  EXPECT_THAT(softsoil_error(), HasSubstr("the mjData are of different models"));
  EXPECT_EQ(softsoil_wheel_count(bare.get()), -1);
}

TEST(SimulationOfAnotherModel, IsNeitherSavedNorLoaded) {
  Simulation a(CompactingWheel());
  const Model m = Load(World(R"(<body><freejoint/><geom size=".1"/></body>)"));
  const std::string path = testing::TempDir() + "softsoil_model_" + std::to_string(getpid());
  EXPECT_EQ(softsoil_save_simulation(m.get(), a.d.get(), path.c_str()), -1);
  EXPECT_THAT(softsoil_error(), HasSubstr("no soil for this mjModel"));
  EXPECT_EQ(softsoil_load_simulation(m.get(), a.d.get(), path.c_str()), -1);
  EXPECT_THAT(softsoil_error(), HasSubstr("no soil for this mjModel"));
}

}  // namespace
}  // namespace softsoil
