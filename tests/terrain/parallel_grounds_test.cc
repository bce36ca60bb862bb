// Grounds that are pressed by threads of their own, all at once.
#include <gtest/gtest.h>

#include <future>
#include <vector>

#include "terrain/ground.h"
#include "terrain/worker_pool.h"
#include "tests/terrain/pressed_ground.h"

namespace softsoil {
namespace {

// Height [m] of the middle at every tick, under a plate of its own pressure.
std::vector<double> Heights(bool sync, int which) {
  GroundSettings settings;
  settings.grid_spacing = settings.volume_height = 0.05;
  settings.volumes = 24;
  settings.sync = sync;
  settings.threads = 4;
  Ground ground(LooseSoil(), settings, FlatGround, 1);
  std::vector<double> heights;
  for (int tick = 0; tick < 20; ++tick) {
    ground.AddLoad(0, ForcesOf({{0, 0}, 0.2, 200e3 + 5e3 * which}, 0.05), 0.01);
    ground.Pass(0.01);
    heights.push_back(ground.surface().NodeHeight({0, 0}));
  }
  return heights;
}

class ParallelGrounds : public testing::TestWithParam<bool> {};
INSTANTIATE_TEST_SUITE_P(, ParallelGrounds, testing::Bool(),
                         [](const auto& sync) { return sync.param ? "Sync" : "Background"; });

TEST_P(ParallelGrounds, AreMoreThanWorkersAndHaveTheBitsOfOneAfterTheOther) {
  const int count = 3 * WorkerPool::Shared().workers() + 1;
  std::vector<std::future<std::vector<double>>> all;
  for (int i = 0; i < count; ++i) {
    all.push_back(std::async(std::launch::async, Heights, GetParam(), i));
  }
  for (int i = 0; i < count; ++i) {
    const std::vector<double> alone = Heights(GetParam(), i);
    EXPECT_LT(alone.back(), -0.001) << "it was pressed";
    EXPECT_EQ(all[i].get(), alone) << i;
  }
}

}  // namespace
}  // namespace softsoil
