// Passive earth pressure against Coulomb's wedge: of all planes along which the soil before a wall
// can fail, it takes the one that resists least.
#include "terrain/earth_pressure.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace softsoil {
namespace {

struct Case {
  double cohesion, friction_angle_deg, gamma, height;
};
constexpr Case kCases[] = {{7100, 21.17, 11774, 0.04},
                           {35720, 23.13, 14754, 0.1},
                           {0, 35, 15000, 0.5},
                           {20000, 0, 18000, 0.3}};

Shear SoilOf(const Case& c) { return {c.cohesion, c.friction_angle_deg * kPi / 180, 0.01}; }

// Horizontal force [N/m] that pushes up a wedge on a plane at `theta` above the horizontal: its
// weight, the cohesion along the plane and the reaction of the plane, tilted by phi, in balance.
double WedgeForce(const Case& c, double theta) {
  const double tilt = std::tan(theta + c.friction_angle_deg * kPi / 180);
  const double weight = c.gamma * c.height * c.height / (2 * std::tan(theta));
  const double adhesion = c.cohesion * c.height / std::sin(theta);
  return (weight + adhesion * std::sin(theta)) * tilt + adhesion * std::cos(theta);
}

TEST(PassiveForce, IsThatOfTheWeakestWedge) {
  for (const Case& c : kCases) {
    double least = 1e300;
    const double steepest = kPi / 2 - c.friction_angle_deg * kPi / 180;
    for (double theta = 0.001; theta < steepest - 0.001; theta += 1e-5) {
      least = std::min(least, WedgeForce(c, theta));
    }
    EXPECT_NEAR(PassiveForce(SoilOf(c), c.gamma, c.height) / least, 1, 1e-6);
  }
}

TEST(PassiveForce, IsTheSumOfThePressure) {
  for (const Case& c : kCases) {
    const int slices = 1000;
    double sum = 0;
    for (int i = 0; i < slices; ++i) {
      const double z = (i + 0.5) * c.height / slices;
      sum += PassivePressure(SoilOf(c), c.gamma, z) * c.height / slices;
    }
    EXPECT_NEAR(PassiveForce(SoilOf(c), c.gamma, c.height) / sum, 1, 1e-9);
  }
}

TEST(PassiveForce, IsNoneAboveTheSurface) {
  const Shear soil = SoilOf(kCases[0]);
  EXPECT_EQ(PassiveForce(soil, 12000, 0), 0);
  EXPECT_EQ(PassiveForce(soil, 12000, -0.1), 0);
  EXPECT_EQ(PassivePressure(soil, 12000, -0.1), 0);
}

}  // namespace
}  // namespace softsoil
