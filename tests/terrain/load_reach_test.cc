#include "terrain/load_reach.h"

#include <gtest/gtest.h>

#include "tests/terrain/stress_case.h"

namespace softsoil {
namespace {

using softsoil_reference::Point;
using softsoil_reference::StressOfAll;

constexpr double kDx = 0.025;  // [m]

// Two wheels apart, each a patch of forces in all directions.
SurfaceLoad TwoWheels(unsigned seed) {
  SurfaceLoad load = RandomLoad({0, 0}, 6, kDx, 0.02, seed);
  SurfaceLoad second = RandomLoad({40, 25}, 4, kDx, 0.02, seed + 1);
  for (NodeForce& f : second) f.source = 1;
  load.insert(load.end(), second.begin(), second.end());
  return load;
}

double MostBelow(const SurfaceLoad& load, double nu, double x, double y) {
  double most = 0;
  for (double z = -0.005; z > -3; z *= 1.1) {
    most = std::max(most, StressOfAll(ForOracle(load), nu, Point{x, y, z}));
  }
  return most;
}

TEST(LoadReach, BoundIsNeverExceeded) {
  for (unsigned seed = 1; seed <= 3; ++seed) {
    for (double nu : {3.0, 4.5, 6.0}) {
      const SurfaceLoad load = TwoWheels(seed);
      const LoadReach reach(load, nu);
      for (double x = -0.6; x < 1.8; x += 0.11) {
        for (double y = -0.6; y < 1.4; y += 0.13) {
          ASSERT_LE(MostBelow(load, nu, x, y), reach.At(x, y).stress) << x << ", " << y;
        }
      }
    }
  }
}

// A bound that is never nearly reached would visit columns for nothing.
TEST(LoadReach, BoundOfOneForceIsReachedButNotExceeded) {
  for (const Eigen::Vector3d& force : {Eigen::Vector3d(0, 0, -1e3), Eigen::Vector3d(1e3, 0, 0)}) {
    const SurfaceLoad load{ForceAt({0, 0}, kDx, 0, force)};
    const double bound = LoadReach(load, 5).At(0.3, 0).stress;
    EXPECT_LE(MostBelow(load, 5, 0.3, 0), bound);
    EXPECT_GT(MostBelow(load, 5, 0.3, 0), 0.99 * bound);
  }
}

TEST(LoadReach, RectanglesHoldWhatTwoSourcesPressTogether) {
  SurfaceLoad load{ForceAt({0, 0}, kDx, 0, {0, 0, -1e3}), ForceAt({0, 0}, kDx, 0, {0, 0, -1e3})};
  load[1].source = 1;
  const double stress = MostBelow(load, 5, 0.3, 0);
  bool inside = false;
  LoadReach(load, 5).ForEachRectangle(stress, [&](double x0, double x1, double, double) {
    inside = inside || (x0 <= -0.3 && x1 >= 0.3);
  });
  EXPECT_TRUE(inside);
}

TEST(LoadReach, OutsideItsRectanglesEveryStressIsBelow) {
  const double stress = 2e3, nu = 4.5;
  const SurfaceLoad load = TwoWheels(7);
  const LoadReach reach(load, nu);
  const auto inside = [&](double x, double y) {
    bool in = false;
    reach.ForEachRectangle(stress, [&](double x0, double x1, double y0, double y1) {
      in = in || (x >= x0 && x <= x1 && y >= y0 && y <= y1);
    });
    return in;
  };
  int in = 0, out = 0;
  for (double x = -1; x < 2.2; x += 0.09) {
    for (double y = -1; y < 1.8; y += 0.09) {
      (inside(x, y) ? in : out) += 1;
      if (inside(x, y)) continue;
      ASSERT_LT(MostBelow(load, nu, x, y), stress) << x << ", " << y;
    }
  }
  EXPECT_GT(in, 20);
  EXPECT_GT(out, 20);
}

TEST(LoadReach, IsUnboundedUnderTheLoadItself) {
  const LoadReach reach(TwoWheels(1), 5);
  EXPECT_TRUE(std::isinf(reach.At(0, 0).stress));
  EXPECT_TRUE(std::isinf(reach.At(2.5 * kDx, 5 * kDx).stress));
  EXPECT_TRUE(std::isfinite(reach.At(-0.01, 0).stress));
}

TEST(LoadReach, NamesTheSourceThatPressesMost) {
  const LoadReach reach(TwoWheels(1), 5);
  EXPECT_EQ(reach.At(0.05, 0.05).source, 0);
  EXPECT_EQ(reach.At(-0.1, 0).source, 0);
  EXPECT_EQ(reach.At(40 * kDx, 25 * kDx).source, 1);
  EXPECT_EQ(reach.At(45 * kDx, 26 * kDx).source, 1);
}

// A wheel that is thrown 10 km within a soil period presses here and there, not in between.
TEST(LoadReach, DoesNotSpanTheWayOfAWheelThatIsThrown) {
  SurfaceLoad load = RandomLoad({0, 0}, 6, kDx, 0.02, 1);
  const SurfaceLoad far = RandomLoad({400000, 400000}, 6, kDx, 0.02, 2);
  load.insert(load.end(), far.begin(), far.end());
  const LoadReach reach(load, 5);
  double area = 0;  // [m^2]
  reach.ForEachRectangle(
      1e3, [&](double x0, double x1, double y0, double y1) { area += (x1 - x0) * (y1 - y0); });
  EXPECT_LT(area, 100);
  for (const double x : {0.0, 0.3, 1e4, 1e4 + 0.3}) {
    EXPECT_LE(MostBelow(load, 5, x, x), reach.At(x, x).stress) << x;
  }
}

TEST(LoadReach, OfNoLoadIsNothing) {
  const LoadReach reach({}, 5);
  EXPECT_EQ(reach.At(0, 0).stress, 0);
  EXPECT_EQ(reach.At(0, 0).source, -1);
  reach.ForEachRectangle(1, [](double, double, double, double) { FAIL(); });
}

// Two wheels side by side at an angle: their rectangles overlap, the forces do not.
TEST(LoadReach, AsksTheForcesWhereTheRectanglesOfSourcesOverlap) {
  SurfaceLoad load;
  for (int source : {0, 1}) {
    for (int k = 0; k <= 10; ++k) {
      const double x = 0.05 * k, y = 0.05 * k + 0.2 * source;
      load.push_back({{0, 0}, x, y, 0, {0, 0, source == 0 ? -10.0 : -100.0}, source});
    }
  }
  const LoadReach reach(load, 5);
  EXPECT_EQ(reach.At(0.25, 0.25).source, 0);
  EXPECT_EQ(reach.At(0.25, 0.45).source, 1);
}

}  // namespace
}  // namespace softsoil
