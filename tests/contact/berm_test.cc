// The soil that a wheel pushes aside.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/contact/soil_bin.h"

namespace softsoil {
namespace {

double Height(SoilBin& bin, double x, double y) { return bin.ground().surface().Height(x, y); }

// Highest ground [m] in a rectangle.
double Highest(SoilBin& bin, double x_min, double x_max, double y_min, double y_max) {
  double highest = -1;
  for (double x = x_min; x <= x_max; x += 0.05) {
    for (double y = y_min; y <= y_max; y += 0.05) highest = std::max(highest, Height(bin, x, y));
  }
  return highest;
}

TEST(Berm, RisesOnBothSidesOfARollingWheel) {
  SoilBin bin{{}};
  bin.Measure(0.1);
  const double behind = bin.pose().centre_w.x() - 0.8;
  EXPECT_GT(Highest(bin, 0.5, behind, 0.2, 0.6), 0.01);
  EXPECT_LT(Highest(bin, 0.5, behind, 0.2, 0.6), 0.10);
  for (double x = -0.5; x < 2; x += 0.1) {
    for (double y = 0.05; y < 0.8; y += 0.05) {
      EXPECT_NEAR(Height(bin, x, y), Height(bin, x, -y), 1e-6) << x << ", " << y;
    }
  }
}

TEST(Berm, KeepsItsVolume) {
  SoilBin bin{{}};
  bin.Measure(0.3);
  const Surface& surface = bin.ground().surface();
  EXPECT_GT(surface.BermVolume(), 0.2 * surface.DisplacedVolume());
  EXPECT_NEAR(surface.MovedVolume() + bin.ground().VolumeInHand(), surface.DisplacedVolume(),
              1e-9 * surface.DisplacedVolume());
}

TEST(Berm, IsHigherBeforeAWheelThatSlides) {
  const auto ahead = [](double slip) {
    SoilBin bin{{}};
    bin.Measure(slip);
    const double axle = bin.pose().centre_w.x();
    return Highest(bin, axle + 0.2, axle + 0.8, -0.2, 0.2);
  };
  const double locked = ahead(-1), rolling = ahead(0.1);
  EXPECT_GT(rolling, 0.01);
  EXPECT_GT(locked, 1.15 * rolling);
}

TEST(Berm, IsPushedAwayByTheNextWheel) {
  SoilBin bin{{}};
  bin.Measure(0.1);
  const double x = 0.8, y = 0.3, berm = Height(bin, x, y);
  ASSERT_GT(berm, 0.005);
  bin.Lift();
  bin.Step();
  bin.PutDownAt(x);
  bin.pose().centre_w.y() = y;
  bin.Drive(0.2, 0, 0);
  EXPECT_LT(Height(bin, x, y), -0.01);
  EXPECT_GT(Highest(bin, x - 0.2, x + 0.2, y + 0.25, y + 0.6), 0.005);
}

}  // namespace
}  // namespace softsoil
