#include "terrain/nurbs_bumps.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

namespace softsoil {
namespace {

constexpr NurbsBumps kBumps = {0.05, 0.8, 7};

// visit(x, y) over a square of 300 bumps by 300, off the grid of control points.
void ForManyPlaces(const std::function<void(double, double)>& visit) {
  for (double x = -120; x < 120; x += 0.43) {
    for (double y = -120; y < 120; y += 0.43) visit(x, y);
  }
}

TEST(NurbsBumps, StayWithinTheirHeightAndUseMostOfIt) {
  double highest = 0, lowest = 0;
  ForManyPlaces([&](double x, double y) {
    highest = std::max(highest, HeightOf(kBumps, x, y));
    lowest = std::min(lowest, HeightOf(kBumps, x, y));
  });
  EXPECT_LE(highest, kBumps.height);
  EXPECT_GE(lowest, -kBumps.height);
  EXPECT_GT(highest, 0.75 * kBumps.height);
  EXPECT_LT(lowest, -0.75 * kBumps.height);
}

// 90,000 control points: their mean is 0 within 3 of its standard deviations, 0.6 height / 300.
TEST(NurbsBumps, AreZeroOnAverageAndAsRoughAsTold) {
  double sum = 0, squares = 0;
  int count = 0;
  ForManyPlaces([&](double x, double y) {
    const double z = HeightOf(kBumps, x, y) / kBumps.height;
    sum += z;
    squares += z * z;
    ++count;
  });
  EXPECT_NEAR(sum / count, 0, 0.006);
  EXPECT_NEAR(std::sqrt(squares / count), 0.29, 0.01);
}

// Across the knots, every 0.8 m, the third derivative leaps. A spline of lower degree would have
// leaps of the curvature as large as the curvature itself.
TEST(NurbsBumps, HaveContinuousSlopeAndCurvature) {
  const double d = 1e-3;
  const auto height = [](double x) { return HeightOf(kBumps, x, 0.3); };
  const auto slope = [&](double x) { return (height(x + d) - height(x - d)) / (2 * d); };
  const auto curvature = [&](double x) {
    return (height(x + d) - 2 * height(x) + height(x - d)) / (d * d);
  };
  double largest_slope = 0, largest_curvature = 0;
  for (int knot = -40; knot < 40; ++knot) {
    const double x = knot * kBumps.spacing;
    largest_slope = std::max(largest_slope, std::abs(slope(x)));
    largest_curvature = std::max(largest_curvature, std::abs(curvature(x)));
    EXPECT_NEAR(height(x - 1e-9), height(x + 1e-9), 1e-9);
    EXPECT_NEAR(slope(x - 2 * d), slope(x + 2 * d), 1e-3);
    EXPECT_NEAR(curvature(x - 2 * d), curvature(x + 2 * d), 0.01);
  }
  EXPECT_GT(largest_slope, 0.03);
  EXPECT_GT(largest_curvature, 0.15);
}

TEST(NurbsBumps, HaveTheSameBitsOnEveryMachine) {
  EXPECT_EQ(HeightOf(kBumps, 0, 0), 0x1.9ea3a6eedd77p-7);
  EXPECT_EQ(HeightOf(kBumps, 0.3, -0.7), 0x1.a1de3bcb71c75p-7);
  EXPECT_EQ(HeightOf(kBumps, -12.5, 40.25), -0x1.84f581137b45cp-11);
  EXPECT_EQ(HeightOf(kBumps, 1e6, -1e6), -0x1.ad79763a3444fp-9);
}

// Correlation of the heights of two grounds, shifted by dx, dy [m].
double Correlation(const NurbsBumps& a, const NurbsBumps& b, double dx = 0, double dy = 0) {
  double ab = 0, aa = 0, bb = 0;
  ForManyPlaces([&](double x, double y) {
    const double at_a = HeightOf(a, x, y), at_b = HeightOf(b, x + dx, y + dy);
    ab += at_a * at_b;
    aa += at_a * at_a;
    bb += at_b * at_b;
  });
  return ab / std::sqrt(aa * bb);
}

TEST(NurbsBumps, HaveNothingInCommonForDifferentSeeds) {
  EXPECT_NEAR(Correlation(kBumps, kBumps), 1, 1e-12);
  for (std::uint32_t seed : {0u, 6u, 8u, 7u + 65536u, 4294967295u}) {
    EXPECT_NEAR(Correlation(kBumps, {kBumps.height, kBumps.spacing, seed}), 0, 0.02) << seed;
  }
}

TEST(NurbsBumps, DoNotRepeat) {
  for (const auto& [i, j] : {std::pair{0, 4}, {4, 0}, {16, 16}, {-256, 1}, {0, 65536}}) {
    EXPECT_NEAR(Correlation(kBumps, kBumps, i * kBumps.spacing, j * kBumps.spacing), 0, 0.02)
        << i << " " << j;
  }
}

// 2^53 spacings out, and wherever a coordinate can be.
TEST(NurbsBumps, StayAsTheyAreWhereDoublesNoLongerTellControlPoints) {
  const double edge = 9007199254740992 * kBumps.spacing;
  const double largest = std::numeric_limits<double>::max();
  const NurbsBumps fine = {0.05, kBumpSpacingLimits.least, 7};  // largest / spacing overflows
  for (double sign : {-1.0, 1.0}) {
    for (double x : {1e19, 1e30, largest}) {
      EXPECT_EQ(HeightOf(kBumps, sign * x, 0.3), HeightOf(kBumps, sign * edge, 0.3)) << x;
      EXPECT_EQ(HeightOf(kBumps, 0.3, sign * x), HeightOf(kBumps, 0.3, sign * edge)) << x;
    }
    EXPECT_LE(std::abs(HeightOf(fine, sign * largest, sign * largest)), fine.height);
  }
}

TEST(NurbsBumps, GrowWithHeightAndSpacing) {
  const NurbsBumps twice = {2 * kBumps.height, kBumps.spacing, kBumps.seed};
  const NurbsBumps wide = {kBumps.height, 2 * kBumps.spacing, kBumps.seed};
  EXPECT_DOUBLE_EQ(HeightOf(twice, 3.1, -2.3), 2 * HeightOf(kBumps, 3.1, -2.3));
  EXPECT_DOUBLE_EQ(HeightOf(wide, 6.2, -4.6), HeightOf(kBumps, 3.1, -2.3));
}

TEST(NurbsBumps, AreAddedToTheGroundAlongZ) {
  const auto slope = [](double x, double y) { return 0.2 * x - 0.1 * y; };
  EXPECT_EQ(WithBumps(slope, kBumps)(3, 4), slope(3, 4) + HeightOf(kBumps, 3, 4));
  EXPECT_EQ(WithBumps(slope, NurbsBumps{})(3, 4), slope(3, 4));
}

}  // namespace
}  // namespace softsoil
