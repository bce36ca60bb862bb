// The choice of the backend of the stress field.
#include <gtest/gtest.h>

#include "terrain/ground.h"
#include "tests/terrain/pressed_ground.h"
#include "tests/terrain/stress_case.h"

namespace softsoil {
namespace {

constexpr double kDx = 0.025;  // [m]
const StressSettings kSettings{{5}, 1.25 * kDx, 1};

std::vector<float> StressBy(StressBackend backend, const ColumnBatch& batch,
                            const SurfaceLoad& load) {
  std::vector<float> stress;
  MakeStressField(backend, kSettings, kDx)->VerticalStress(batch, load, &stress);
  return stress;
}

// 14 x 14 columns of 30 volumes: 17 forces make 100,000 pairs.
const ColumnBatch kBatch = Block({-3, -3}, 14, kDx, 30, kDx, 0);

TEST(AutoStress, IsDirectForFewPairs) {
  const SurfaceLoad load = RandomLoad({0, 0}, 4, kDx, 0, 1);
  const auto field = MakeStressField(StressBackend::kAuto, kSettings, kDx);
  EXPECT_EQ(field->BackendFor(kBatch, load), StressBackend::kDirect);
  EXPECT_EQ(StressBy(StressBackend::kAuto, kBatch, load),
            StressBy(StressBackend::kDirect, kBatch, load));
}

TEST(AutoStress, IsGaussianForManyPairs) {
  const SurfaceLoad load = RandomLoad({0, 0}, 5, kDx, 0, 1);
  const auto field = MakeStressField(StressBackend::kAuto, kSettings, kDx);
  EXPECT_EQ(field->BackendFor(kBatch, load), StressBackend::kGaussian);
  const std::vector<float> stress = StressBy(StressBackend::kAuto, kBatch, load);
  EXPECT_EQ(stress, StressBy(StressBackend::kGaussian, kBatch, load));
  EXPECT_NE(stress, StressBy(StressBackend::kDirect, kBatch, load));
}

// Of a plate on loose soil.
struct Pressed {
  double sinkage;  // [m]
  StressUpdates updates;
};

Pressed PressedBy(StressBackend backend, int threads) {
  GroundSettings settings;
  settings.stress = backend;
  settings.sync = true;
  settings.threads = threads;
  Ground ground(LooseSoil(), settings, FlatGround, 1);
  const std::vector<SurfaceForce> forces = ForcesOf({{0, 0}, 0.2, 250e3}, kDx);
  for (int tick = 0; tick < 20; ++tick) {
    ground.AddLoad(0, forces, 0.01);
    ground.Pass(0.01);
  }
  return {-ground.surface().NodeHeight({0, 0}), ground.stress_updates()};
}

TEST(AutoStress, SinksAPlateAsDeepAsTheDirectSum) {
  const Pressed direct = PressedBy(StressBackend::kDirect, 2);
  const Pressed gaussian = PressedBy(StressBackend::kGaussian, 2);
  ASSERT_GT(direct.sinkage, 0.005);
  EXPECT_NE(gaussian.sinkage, direct.sinkage);
  EXPECT_NEAR(gaussian.sinkage, direct.sinkage, 0.01 * direct.sinkage);
  EXPECT_EQ(PressedBy(StressBackend::kAuto, 2).sinkage, gaussian.sinkage);
}

TEST(AutoStress, SinksAPlateByTheSameBitsOnAnyNumberOfThreads) {
  const double one = PressedBy(StressBackend::kGaussian, 1).sinkage;
  EXPECT_EQ(PressedBy(StressBackend::kGaussian, 2).sinkage, one);
  EXPECT_EQ(PressedBy(StressBackend::kGaussian, 3).sinkage, one);
}

TEST(AutoStress, TellsWhereTheStressCameFrom) {
  const StressUpdates direct = PressedBy(StressBackend::kDirect, 1).updates;
  EXPECT_EQ(direct.direct, 20u);
  EXPECT_EQ(direct.gaussian, 0u);
  const StressUpdates chosen = PressedBy(StressBackend::kAuto, 1).updates;
  EXPECT_EQ(chosen.direct, 0u);
  EXPECT_EQ(chosen.gaussian, 20u);
}

}  // namespace
}  // namespace softsoil
