// Grounds that are copied, written and read.
#include <gmock/gmock.h>

#include <cmath>
#include <functional>
#include <memory>
#include <stdexcept>
#include <vector>

#include "terrain/ground.h"
#include "terrain/input_error.h"
#include "tests/terrain/pressed_ground.h"
#include "tests/terrain/written_bytes.h"

namespace softsoil {
namespace {

GroundSettings Settings(bool sync) { return CoarseGround(12, sync); }

Ground Undisturbed(bool sync) { return Ground(LooseSoil(), Settings(sync), FlatGround, 2); }

// A plate that moves on by a node every tick, under the sources in turn; `steps` of 1 ms.
void Drive(Ground& ground, int from, int steps) {
  for (int step = from; step < from + steps; ++step) {
    const Circle plate{{step / 10, 0}, 0.15, 250e3};
    std::vector<SurfaceForce> forces = ForcesOf(plate, 0.05);
    for (SurfaceForce& force : forces) force.slip_volume = 1e-7;
    ground.AddLoad(step / 20 % 2, forces, 0.001);
    ground.DeepenPlastic(0, {{plate.centre, 0.01 + 0.0001 * step}});
    ground.Pass(0.001);
  }
}

class GroundState : public testing::TestWithParam<bool> {};

// 117 steps: in the midst of a soil period, with a job in flight unless it is in sync.
TEST_P(GroundState, GoesOnAlikeInACopy) {
  Ground plain = Undisturbed(GetParam());
  Drive(plain, 0, 300);
  Ground original = Undisturbed(GetParam());
  Drive(original, 0, 117);
  Ground copy = original;
  Drive(copy, 117, 183);
  Drive(original, 117, 183);
  EXPECT_LT(plain.surface().NodeHeight({10, 0}), -0.01);
  EXPECT_GT(plain.Work(1).energy, 0);
  EXPECT_EQ(BytesOf(original), BytesOf(plain));
  EXPECT_EQ(BytesOf(copy), BytesOf(plain));
}

TEST_P(GroundState, IsNotChangedByWhatHappensToACopy) {
  Ground original = Undisturbed(GetParam());
  Drive(original, 0, 117);
  const auto before = BytesOf(original);
  Ground copy = original;
  Drive(copy, 117, 100);
  EXPECT_NE(BytesOf(copy), before);
  EXPECT_EQ(BytesOf(original), before);
}

TEST_P(GroundState, GoesOnAlikeWhenItWasWrittenAndRead) {
  Ground plain = Undisturbed(GetParam());
  Drive(plain, 0, 117);
  const auto bytes = BytesOf(plain);
  Ground read = Undisturbed(GetParam());
  StateReader reader(bytes.data(), bytes.size());
  read.Read(reader);
  EXPECT_EQ(reader.left(), 0u);
  EXPECT_EQ(BytesOf(read), bytes);
  Drive(plain, 117, 100);
  Drive(read, 117, 100);
  EXPECT_EQ(BytesOf(read), BytesOf(plain));
}

TEST_P(GroundState, IsRefusedIfCutOff) {
  Ground ground = Undisturbed(GetParam());
  Drive(ground, 0, 57);
  const auto bytes = BytesOf(ground);
  for (std::size_t count = 0; count < bytes.size(); count += 1 + count / 3) {
    Ground read = Undisturbed(GetParam());
    StateReader reader(bytes.data(), count);
    EXPECT_THROW(read.Read(reader), InputError) << count;
  }
}

TEST_P(GroundState, CopiesNoSoilWhileThereIsNoCopy) {
  Ground ground = Undisturbed(GetParam());
  Drive(ground, 0, 300);
  EXPECT_EQ(ground.BytesCopied(), 0u);
  const Ground copy = ground;
  Drive(ground, 300, 100);
  EXPECT_GT(ground.BytesCopied(), 0u);
}

INSTANTIATE_TEST_SUITE_P(InBackgroundAndSync, GroundState, testing::Bool());

// A stress field that fails as soon as it is told to.
class FailingStress : public StressField {
 public:
  FailingStress(std::unique_ptr<StressField> sound, const bool* fails)
      : sound_(std::move(sound)), fails_(fails) {}
  StressBackend BackendFor(const ColumnBatch& batch, const SurfaceLoad& load) const override {
    return sound_->BackendFor(batch, load);
  }
  void VerticalStress(const ColumnBatch& batch, const SurfaceLoad& load,
                      std::vector<float>* stress) const override {
    if (*fails_) throw std::runtime_error("no stress");
    sound_->VerticalStress(batch, load, stress);
  }

 private:
  std::unique_ptr<StressField> sound_;
  const bool* fails_;
};

TEST(ColumnsState, StaysAsItWasWhenTheStressFieldThrows) {
  bool fails = false;
  const bool never = false;
  const Soil soil = LooseSoil();
  const ColumnSettings settings{0.05, 0.05, 12};
  const auto columns = [&](const bool* when) {
    return Columns(soil, settings, FlatGround,
                   std::make_unique<FailingStress>(
                       MakeDirectStress({{soil.concentration_factor}, 0.0625, 1}), when));
  };
  Columns failing = columns(&fails), plain = columns(&never);
  const auto densities = [](const Columns& c) { return c.Densities({0, 0}); };
  const SurfaceLoad load = LoadOf({{0, 0}, 0.15, 250e3}, 0.05);
  failing.Advance(load, 0.01);
  plain.Advance(load, 0.01);
  fails = true;
  EXPECT_THROW(failing.Advance(load, 0.01), std::runtime_error);
  EXPECT_EQ(densities(failing), densities(plain));
  fails = false;
  failing.Advance(load, 0.01);
  plain.Advance(load, 0.01);
  EXPECT_EQ(densities(failing), densities(plain));
  EXPECT_GT(densities(plain)[3], 1200);
}

TEST(ColumnsState, StaysSharedWhereNothingChanges) {
  Columns columns = FlatColumns({0.05, 0.05, 12});
  const SurfaceLoad weak = LoadOf({{0, 0}, 0.15, 50e3}, 0.05);
  const SurfaceLoad strong = LoadOf({{0, 0}, 0.15, 250e3}, 0.05);
  columns.Advance(weak, 0.01);
  const Columns copy = columns;
  EXPECT_FALSE(columns.Advance(weak, 0.01).compaction.empty());
  EXPECT_EQ(columns.BytesCopied(), 0u);
  columns.Advance(strong, 0.01);
  EXPECT_GT(columns.BytesCopied(), 0u);
}

TEST(SurfaceState, StaysSharedWhereNothingChanges) {
  Surface surface(0.05, SurfaceMode::kFlow, FlatGround);
  surface.DeepenPlastic({{1, 2}, 0.03});
  surface.SetCompaction({{1, 2}, 0.01});
  const Surface copy = surface;
  surface.DeepenPlastic({{1, 2}, 0.02});
  surface.SetCompaction({{1, 2}, 0.01});
  EXPECT_EQ(surface.BytesCopied(), 0u);
  surface.DeepenPlastic({{1, 2}, 0.04});
  EXPECT_GT(surface.BytesCopied(), 0u);
  EXPECT_EQ(copy.NodeHeight({1, 2}), -0.03);
}

}  // namespace
}  // namespace softsoil
