// Soil as state: after any copy, snapshot or file the future has the same bits as without.
#include <gmock/gmock.h>
#include <unistd.h>

#include <cstdio>
#include <memory>
#include <string>

#include "tests/plugin/simulation.h"

namespace softsoil {
namespace {

// Soil that compacts, in the background.
OneWheel CompactingWheel(int nuserdata = 0) {
  OneWheel model;
  model.custom = R"(<text name="softsoil_soil" data="upland_sandy_loam"/>
                    <numeric name="softsoil_volumes" data="10"/>)";
  model.others = "<size nuserdata=\"" + std::to_string(nuserdata) + "\"/>";
  return model;
}

std::uint64_t Hash(const Simulation& sim) {
  std::uint64_t hash = 0;
  EXPECT_EQ(softsoil_hash(sim.d.get(), &hash), 0) << softsoil_error();
  return hash;
}

struct Driven : Simulation {
  explicit Driven(const OneWheel& model = CompactingWheel()) : Simulation(model) {
    d->qvel[0] = 1;
    Run(0.2);
  }
};

void ExpectSameFuture(Simulation& a, Simulation& b) {
  EXPECT_EQ(Hash(a), Hash(b));
  a.Run(0.3);
  b.Run(0.3);
  EXPECT_LT(a.Height(a.d->qpos[0]), -0.005);
  EXPECT_EQ(Hash(a), Hash(b));
  for (int k = 0; k < a.m->nq; ++k) EXPECT_EQ(a.d->qpos[k], b.d->qpos[k]);
}

TEST(SoilState, GoesOnAlikeInACopy) {
  Driven a;
  Simulation b(CompactingWheel());
  mj_copyData(b.d.get(), b.m.get(), a.d.get());
  ASSERT_EQ(softsoil_copy(b.d.get(), a.d.get()), 0) << softsoil_error();
  ExpectSameFuture(a, b);
}

TEST(SoilState, MayBeCopiedBeforeTheMjData) {
  Driven a;
  Simulation b(CompactingWheel());
  ASSERT_EQ(softsoil_copy(b.d.get(), a.d.get()), 0) << softsoil_error();
  mj_copyData(b.d.get(), b.m.get(), a.d.get());
  ExpectSameFuture(a, b);
}

TEST(SoilState, GoesOnAlikeInACopyThatHadNoSoil) {
  Driven a;
  const Data d = MakeData(a.m);
  mj_copyData(d.get(), a.m.get(), a.d.get());
  ASSERT_EQ(softsoil_copy(d.get(), a.d.get()), 0) << softsoil_error();
  for (int i = 0; i < 100; ++i) {
    mj_step(a.m.get(), d.get());
    mj_step(a.m.get(), a.d.get());
  }
  for (int k = 0; k < a.m->nq; ++k) EXPECT_EQ(a.d->qpos[k], d->qpos[k]);
  for (int k = 0; k < 6 * a.m->nbody; ++k) EXPECT_EQ(a.d->xfrc_applied[k], d->xfrc_applied[k]);
}

TEST(SoilState, IsOneOfItsOwnInACopy) {
  Driven a;
  const Data d = MakeData(a.m);
  mj_copyData(d.get(), a.m.get(), a.d.get());
  ASSERT_EQ(softsoil_copy(d.get(), a.d.get()), 0) << softsoil_error();
  const std::uint64_t before = Hash(a);
  for (int i = 0; i < 100; ++i) mj_step(a.m.get(), d.get());
  EXPECT_EQ(Hash(a), before);
}

TEST(SoilState, IsCopiedAfterTheModelThatSteppedItIsGone) {
  Driven a;
  {
    const Model copy(mj_copyModel(nullptr, a.m.get()));
    mj_step(copy.get(), a.d.get());
  }
  const Data d = MakeData(a.m);
  mj_copyData(d.get(), a.m.get(), a.d.get());
  ASSERT_EQ(softsoil_copy(d.get(), a.d.get()), 0) << softsoil_error();
  mj_step(a.m.get(), d.get());
  mj_step(a.m.get(), a.d.get());
  EXPECT_EQ(softsoil_wheel_count(d.get()), 1) << softsoil_error();
  EXPECT_EQ(d->qpos[0], a.d->qpos[0]);
  EXPECT_EQ(d->qpos[1], a.d->qpos[1]);
}

TEST(SoilState, IsRestoredFromASnapshotAnyNumberOfTimes) {
  Driven a, plain;
  const Data saved = MakeData(a.m);
  mj_copyData(saved.get(), a.m.get(), a.d.get());
  softsoilSnapshot* snapshot = softsoil_snapshot(a.d.get());
  ASSERT_NE(snapshot, nullptr) << softsoil_error();
  for (int i = 0; i < 3; ++i) {
    a.Run(0.1 * i);
    mj_copyData(a.d.get(), a.m.get(), saved.get());
    ASSERT_EQ(softsoil_restore(a.d.get(), snapshot), 0) << softsoil_error();
  }
  softsoil_free_snapshot(snapshot);
  ExpectSameFuture(a, plain);
}

TEST(SoilState, GoesOnAlikeFromAFile) {
  const std::string path = testing::TempDir() + "softsoil_state_" + std::to_string(getpid());
  Driven a;
  ASSERT_EQ(softsoil_save_simulation(a.m.get(), a.d.get(), path.c_str()), 0) << softsoil_error();
  Simulation b(CompactingWheel());
  ASSERT_EQ(softsoil_load_simulation(b.m.get(), b.d.get(), path.c_str()), 0) << softsoil_error();
  std::remove(path.c_str());
  ExpectSameFuture(a, b);
}

TEST(SoilState, FollowsAMjDataThatIsCopied) {
  Driven a(CompactingWheel(2)), plain(CompactingWheel(2));
  Simulation b(CompactingWheel(2));
  mj_copyData(b.d.get(), b.m.get(), a.d.get());
  b.Run(0.001);
  a.Run(0.001);
  ExpectSameFuture(a, b);
  plain.Run(0.301);
  EXPECT_EQ(Hash(a), Hash(plain)) << "marks leave no trace";
}

TEST(SoilState, FollowsAMjDataThatIsRestored) {
  Driven a(CompactingWheel(2)), plain(CompactingWheel(2));
  const Data saved = MakeData(a.m);
  mj_copyData(saved.get(), a.m.get(), a.d.get());
  a.Run(0.2);
  mj_copyData(a.d.get(), a.m.get(), saved.get());
  a.Run(0.001);
  plain.Run(0.001);
  ExpectSameFuture(a, plain);
}

}  // namespace
}  // namespace softsoil
