#include "contact/flat_plate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/contact/samples.h"

namespace softsoil {
namespace {

// The load as an integral over the plate rather than over the tire. With a = r - z the height of
// the axis, the node that comes to lie at x, y has the penetration R(y) - sqrt(x^2 + a^2); the area
// law and the two cosines of its normal leave cos^2(theta) = a^2 / (x^2 + a^2) per area of plate:
//   F = int int f(R(y) - sqrt(x^2 + a^2)) a^2 / (x^2 + a^2) dx dy
double PlateIntegral(const Tire& tire, double z) {
  const double a = tire.shape.radius - z, b = tire.shape.width, crown = tire.shape.crown_radius;
  constexpr int kPoints = 1000;  // midpoints along the half width and along the half length
  double load = 0;
  for (int j = 0; j < kPoints; ++j) {
    const double y = (j + 0.5) / kPoints * b / 2;
    const double drop = std::isinf(crown) ? 0 : crown - std::sqrt(crown * crown - y * y);
    const double R = tire.shape.radius - drop;
    if (R <= a) continue;
    const double half_length = std::sqrt(R * R - a * a);
    for (int i = 0; i < kPoints; ++i) {
      const double x = (i + 0.5) / kPoints * half_length, c2 = x * x + a * a;
      const double d = R - std::sqrt(c2);
      const double pressure = tire.spring.linear * d + tire.spring.root * std::sqrt(d);
      load += 4 * pressure * a * a / c2 * half_length / kPoints * b / 2 / kPoints;
    }
  }
  return load;
}

// Section 6.2.1: 26,950 N at 0.1 m.
TEST(FlatPlate, CarriesThePublishedLoadOfThe18_4R38) {
  EXPECT_NEAR(FlatPlateLoad(AgriculturalTire(), 0.1, 0.025), 26950, 0.002 * 26950);
  const Tire tire = AgriculturalTire();
  EXPECT_NEAR(FlatPlateLoad(tire.shape, tire.spring, 0.1), 26950, 0.001 * 26950);
}

TEST(FlatPlate, AgreesWithTheIntegralOverThePlate) {
  for (const char* name : {"18.4R38_85kPa", "18.4R38_125kPa", "24.5R32_85kPa", "37x12.5R16.5_15psi",
                           "37x12.5R16.5_35psi"}) {
    for (double z : {0.02, 0.05, 0.1}) {
      const double load = PlateIntegral(TireNamed(name), z);
      EXPECT_NEAR(FlatPlateLoad(TireNamed(name), z, 0.002) / load, 1, 1e-3) << name << " " << z;
      const Tire tire = TireNamed(name);
      EXPECT_NEAR(FlatPlateLoad(tire.shape, tire.spring, z) / load, 1, 2e-5) << name << " " << z;
      EXPECT_NEAR(FlatPlateLoad(TireNamed(name), z, 0.025) / load, 1, 0.03) << name << " " << z;
    }
  }
}

TEST(FlatPlate, ConvergesAsTheNodesGetCloser) {
  const Tire tire = AgriculturalTire();
  const double load = PlateIntegral(tire, 0.1);
  const auto worst = [&](double spacing) {
    double error = 0;  // over some spacings: one alone may be right by chance
    for (double s = spacing; s < 1.3 * spacing; s *= 1.05) {
      error = std::max(error, std::abs(FlatPlateLoad(tire, 0.1, s) / load - 1));
    }
    return error;
  };
  EXPECT_LT(worst(0.02), worst(0.08) / 2);
  EXPECT_LT(worst(0.005), worst(0.02) / 2);
}

// A linear cylinder in closed form. The loaded node has the area w (r - z) / cos(theta) dtheta:
//   F = 2 w a (r - z) (r theta_r - (r - z) ln(sec theta_r + tan theta_r))
TEST(FlatPlate, HasAClosedFormForALinearCylinder) {
  const Tire tire = TruckTire();
  const double r = tire.shape.radius, w = tire.shape.width, a = tire.spring.linear;
  for (double z : {0.01, 0.0508, 0.1}) {
    const double angle = std::acos((r - z) / r);
    const double load = 2 * w * a * (r - z) *
                        (r * angle - (r - z) * std::log(1 / std::cos(angle) + std::tan(angle)));
    EXPECT_NEAR(FlatPlateLoad(tire, z, 0.001) / load, 1, 2e-4) << z;
    EXPECT_NEAR(FlatPlateLoad(tire.shape, tire.spring, z) / load, 1, 1e-9) << z;
  }
}

// Equation 4.18 projects the unloaded area onto the plate, w r cos(theta) dtheta, where ours
// shrinks it with the radius. They differ by the share z / r at most, and agree for a small one.
TEST(FlatPlate, ApproachesEquation4_18ForSmallDeflections) {
  const Tire tire = TruckTire();
  const double r = tire.shape.radius, w = tire.shape.width, a = tire.spring.linear;
  for (double z : {0.003, 0.01, 0.0508, 0.1}) {
    const double angle = std::acos((r - z) / r);
    const double load =
        2 * w * r * a * (r * (angle / 2 + std::sin(2 * angle) / 4) - (r - z) * std::sin(angle));
    EXPECT_NEAR(FlatPlateLoad(tire, z, 0.001) / load, 1, z / r) << z;
  }
}

TEST(FlatPlate, CarriesMoreTheDeeperTheTireIsPressed) {
  for (const Tire& tire : {AgriculturalTire(), TruckTire()}) {
    EXPECT_EQ(FlatPlateLoad(tire, 0, 0.02), 0);
    EXPECT_EQ(FlatPlateLoad(tire, -0.1, 0.02), 0);
    for (double z = 0.005; z < 0.2; z += 0.005) {
      EXPECT_GT(FlatPlateLoad(tire, z, 0.02), FlatPlateLoad(tire, z - 0.005, 0.02));
    }
  }
}

}  // namespace
}  // namespace softsoil
