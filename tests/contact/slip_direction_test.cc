// Slip as a vector: how a node that slides to and fro, or aside, mobilises the soil.
#include <gtest/gtest.h>

#include <cmath>

#include "terrain/shear.h"

namespace softsoil {
namespace {

constexpr double kModulus = 0.0106;  // [m]

// Slips the distance j [m] at the direction `angle` [rad] in equal steps.
Mobilisation Slipped(Mobilisation m, double j, double angle, int steps) {
  for (int k = 0; k < steps; ++k) {
    m = Slip(m, std::cos(angle), std::sin(angle), j / steps, kModulus);
  }
  return m;
}

TEST(Slip, DependsOnDistanceAndNotOnSpeed) {
  const Mobilisation slow = Slip({0.2, -0.1}, 0.03, 0.04, 0.1, kModulus);
  const Mobilisation fast = Slip({0.2, -0.1}, 3, 4, 0.001, kModulus);
  EXPECT_NEAR(slow.t, fast.t, 1e-14);
  EXPECT_NEAR(slow.b, fast.b, 1e-14);
}

TEST(Slip, TurnsToTheDirectionOfTheSlip) {
  const Mobilisation m = Slipped(Slipped({0, 0}, 0.1, 0, 5), 0.1, 2.5, 5);
  EXPECT_NEAR(std::atan2(m.b, m.t), 2.5, 1e-3);
}

TEST(Slip, KnowsNoPreferredAxis) {
  const double angle = 1.1, c = std::cos(angle), s = std::sin(angle);
  const auto rotated = [&](double t, double b) {
    return Mobilisation{c * t - s * b, s * t + c * b};
  };
  const Mobilisation v{0.3, -0.8};
  const Mobilisation plain = Slip({0.5, 0.2}, v.t, v.b, 0.01, kModulus);
  const Mobilisation v_rotated = rotated(v.t, v.b);
  const Mobilisation turned = Slip(rotated(0.5, 0.2), v_rotated.t, v_rotated.b, 0.01, kModulus);
  EXPECT_NEAR(turned.t, rotated(plain.t, plain.b).t, 1e-15);
  EXPECT_NEAR(turned.b, rotated(plain.t, plain.b).b, 1e-15);
}

}  // namespace
}  // namespace softsoil
