#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "terrain/surface.h"

namespace softsoil {
namespace {

constexpr double kDx = 0.1;  // [m]

double Hills(double x, double y) { return 0.3 * std::sin(2 * x) + 0.2 * std::cos(3 * y) + 5; }

// Hills with a rut over a tile border, on both sides of zero.
Surface RuttedHills() {
  Surface surface(kDx, SurfaceMode::kFlow, Hills);
  for (int i = -20; i <= 20; ++i) {
    for (int j = -3; j <= 3; ++j) surface.DeepenPlastic({{i, j}, 0.01 * (i * i % 7 + j + 4)});
  }
  return surface;
}

// Bilinear by its definition: the average of the corners weighted with the opposite areas.
double Weighted(const Surface& surface, double x, double y) {
  const int i = static_cast<int>(std::floor(x / kDx)), j = static_cast<int>(std::floor(y / kDx));
  const double u = x / kDx - i, v = y / kDx - j;
  return (1 - u) * (1 - v) * surface.NodeHeight({i, j}) +
         u * (1 - v) * surface.NodeHeight({i + 1, j}) +
         (1 - u) * v * surface.NodeHeight({i, j + 1}) + u * v * surface.NodeHeight({i + 1, j + 1});
}

TEST(SurfaceHeight, AtNodesIsThatOfTheNode) {
  const Surface surface = RuttedHills();
  for (int i : {-33, -17, -16, -1, 0, 1, 15, 16, 31, 32}) {
    EXPECT_NEAR(surface.Height(i * kDx, -i * kDx), surface.NodeHeight({i, -i}), 1e-12) << i;
  }
}

TEST(SurfaceHeight, InTheMiddleOfACellIsTheMeanOfItsCorners) {
  Surface surface(kDx, SurfaceMode::kFlow, [](double, double) { return 1.0; });
  surface.DeepenPlastic({{-1, -1}, 0.4});
  EXPECT_NEAR(surface.Height(-0.05, -0.05), 0.9, 1e-12);
  EXPECT_NEAR(surface.Height(-0.15, -0.15), 0.9, 1e-12);
  EXPECT_NEAR(surface.Height(0.05, 0.05), 1.0, 1e-12);
}

TEST(SurfaceHeight, IsBilinearEverywhereAlsoAcrossTileBordersAndBelowZero) {
  const Surface surface = RuttedHills();
  std::mt19937 random(1);
  std::uniform_real_distribution<double> place(-4, 4);
  for (int n = 0; n < 2000; ++n) {
    const double x = place(random), y = place(random);
    ASSERT_NEAR(surface.Height(x, y), Weighted(surface, x, y), 1e-12) << x << ", " << y;
  }
}

TEST(SurfaceHeight, HasNoStepAtATileBorder) {
  const Surface surface = RuttedHills();
  for (int border : {-16, 0, 16}) {
    const double x = border * kDx;
    EXPECT_NEAR(surface.Height(x - 1e-9, 0.04), surface.Height(x + 1e-9, 0.04), 1e-7) << border;
    EXPECT_NEAR(surface.Height(0.04, x - 1e-9), surface.Height(0.04, x + 1e-9), 1e-7) << border;
  }
}

TEST(SurfacePatch, IsTheSurface) {
  const Surface surface = RuttedHills();
  SurfacePatch patch;
  surface.CopyPatch(-1.93, 1.87, -0.52, 1.71, &patch);
  std::mt19937 random(2);
  std::uniform_real_distribution<double> along(-1.93, 1.87), across(-0.52, 1.71);
  for (int n = 0; n < 2000; ++n) {
    const double x = along(random), y = across(random);
    ASSERT_TRUE(patch.Covers(x, y));
    const SurfacePoint point = patch.At(x, y);
    ASSERT_NEAR(point.height, surface.Height(x, y), 1e-12) << x << ", " << y;
    ASSERT_LE(point.height, patch.highest());
  }
}

TEST(SurfacePatch, HasTheSlopesOfFiniteDifferences) {
  const Surface surface = RuttedHills();
  SurfacePatch patch;
  surface.CopyPatch(-2, 2, -2, 2, &patch);
  const double e = 1e-6;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> cell(-19, 18), within(0.1, 0.9);
  double steepest = 0;
  for (int n = 0; n < 500; ++n) {
    const double x = (std::floor(cell(random)) + within(random)) * kDx;
    const double y = (std::floor(cell(random)) + within(random)) * kDx;
    const SurfacePoint point = patch.At(x, y);
    ASSERT_NEAR(point.slope_x, (patch.At(x + e, y).height - patch.At(x - e, y).height) / (2 * e),
                1e-6);
    ASSERT_NEAR(point.slope_y, (patch.At(x, y + e).height - patch.At(x, y - e).height) / (2 * e),
                1e-6);
    steepest = std::max(steepest, std::abs(point.slope_x));
  }
  EXPECT_GT(steepest, 0.2);
}

TEST(SurfacePatch, KnowsTheUndisturbedSlopeUnderARut) {
  Surface surface(kDx, SurfaceMode::kFlow, [](double x, double y) { return 0.1 * x - 0.2 * y; });
  surface.DeepenPlastic({{0, 0}, 0.05});
  SurfacePatch patch;
  surface.CopyPatch(0, 0.05, 0, 0.05, &patch);
  const SurfacePoint point = patch.At(0.03, 0.06);
  EXPECT_NEAR(point.undisturbed_x, 0.1, 1e-12);
  EXPECT_NEAR(point.undisturbed_y, -0.2, 1e-12);
  EXPECT_GT(std::abs(point.slope_x - 0.1), 0.1);
  EXPECT_NEAR(point.height + point.sinkage, 0.003 - 0.012, 1e-12);
}

TEST(SurfacePatch, TellsWhatItCovers) {
  SurfacePatch patch;
  RuttedHills().CopyPatch(-0.15, 0.25, 0.05, 0.06, &patch);
  EXPECT_TRUE(patch.Covers(-0.2, 0));
  EXPECT_TRUE(patch.Covers(0.3, 0.1));
  EXPECT_FALSE(patch.Covers(-0.2001, 0.05));
  EXPECT_FALSE(patch.Covers(0, 0.1001));
}

}  // namespace
}  // namespace softsoil
