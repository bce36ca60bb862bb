// When memory runs out at a tick of the soil clock, nothing has moved, and the tick that was put
// off does what it would have done.
#include <gtest/gtest.h>

#include <new>
#include <string>
#include <vector>

#include "terrain/ground.h"
#include "tests/faults/failing_memory.h"
#include "tests/terrain/pressed_ground.h"
#include "tests/terrain/written_bytes.h"

namespace softsoil {
namespace {

constexpr double kPeriod = 0.01;  // [s]

GroundSettings Settings(bool sync) {
  GroundSettings settings = CoarseGround(8, sync);
  settings.soil_clock = kPeriod;
  return settings;
}

// A plate that drags soil along x and presses deeper every period; it leaves the tick to the
// caller.
void Press(Ground& ground, int period) {
  const Circle plate{{period / 2, 0}, 0.15, 250e3};
  std::vector<SurfaceForce> forces = ForcesOf(plate, 0.05);
  for (SurfaceForce& force : forces) force.force_w.x() = -0.3 * force.force_w.z();
  for (SurfaceForce& force : forces) force.slip_volume = 1e-7;
  std::vector<NodeSinkage> depths;
  ForEachNodeIn(plate, 0.05, [&](GridNode node) {
    depths.push_back({node, 0.03 + 0.005 * period});
  });
  ground.Reserve(0, forces, depths);
  ground.AddLoad(0, forces, kPeriod);
  ground.DeepenPlastic(0, depths);
}

std::vector<double> Volumes(const Ground& ground) {
  const Surface& surface = ground.surface();
  return {surface.RutVolume(),       surface.BermVolume(),  surface.CompactionVolume(),
          surface.DisplacedVolume(), surface.MovedVolume(), ground.VolumeInHand(),
          ground.Work(0).energy};
}

class GroundTick : public testing::TestWithParam<bool> {};

TEST_P(GroundTick, IsDoneOnceWhereverMemoryRanOut) {
  Ground pressed(LooseSoil(), Settings(GetParam()), FlatGround, 1);
  for (int period = 0; period < 8; ++period) {
    Press(pressed, period);
    if (period < 7) pressed.Pass(kPeriod);
  }
  const std::vector<double> before = Volumes(pressed);
  Ground plain = pressed;
  plain.Pass(kPeriod);
  ASSERT_NE(Volumes(plain), before);

  int failed = 0;
  for (long n = 1;; n += 1 + n / 40) {
    SCOPED_TRACE("allocation " + std::to_string(n));
    Ground ground = pressed;
    bool has_failed = false, is_put_off = false;
    {
      const FailingMemory memory(Whose::kThisThread, n);
      try {
        ground.Pass(kPeriod);
      } catch (const std::bad_alloc&) {
        is_put_off = true;
      }
      has_failed = memory.HasFailed();
    }
    if (is_put_off) {
      ++failed;
      EXPECT_EQ(Volumes(ground), before);
      ground.Pass(0);
    }
    EXPECT_EQ(Volumes(ground), Volumes(plain));
    ASSERT_EQ(BytesOf(ground), BytesOf(plain));
    if (!has_failed) break;
  }
  EXPECT_GT(failed, 20);
}

INSTANTIATE_TEST_SUITE_P(InBackgroundAndSync, GroundTick, testing::Bool());

}  // namespace
}  // namespace softsoil
