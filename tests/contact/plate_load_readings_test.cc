// The integral of the flat-plate load against the equations of the thesis and its readings.
#include <gtest/gtest.h>

#include <cmath>

#include "contact/flat_plate.h"
#include "tests/contact/tire_tables.h"
#include "tests/reference/plate_load_oracle.h"

namespace softsoil {
namespace {

const double kPi = std::acos(-1.0);
const PlateReading kPrinted{kPi, false, true, false};
const PlateReading kBySymmetry{4, true, true, false};  // exact area, 4.26 otherwise
const PlateReading kOurs{4, true, false, true};

double Oracle(const TireShape& shape, const TireSpring& spring, double z,
              const PlateReading& reading) {
  const auto pressure = [&](double d) {
    return spring.linear * d + spring.quadratic * d * d + spring.cubic * d * d * d +
           spring.root * std::sqrt(d);
  };
  return PlateLoadOracle(shape.radius, shape.crown_radius, shape.width, pressure, z, reading);
}

double Ours(const TireShape& shape, const TireSpring& spring, double z) {
  return FlatPlateLoad(shape, spring, z);
}

TEST(PlateLoad, IsTheIntegralOverTheTireWithTheLoadedArea) {
  for (const PrintedTire& tire : PrintedTires()) {
    for (const PrintedSpring& printed : tire.All()) {
      for (double z : {0.001, 0.02, 0.03, 0.06, 0.1, 0.2, 0.5}) {
        EXPECT_NEAR(
            Ours(tire.shape, printed.spring, z) / Oracle(tire.shape, printed.spring, z, kOurs), 1,
            2e-8)
            << tire.name << " " << z;
      }
    }
  }
}

// 4.2.2 with r_beta = b / 2, a full half circle, and with z above r_beta.
TEST(PlateLoad, HoldsForATireAsRoundAsItsWidth) {
  const TireShape ball{0.5, 0.1, 0.2};
  for (double z : {0.05, 0.0999, 0.1, 0.11, 0.15}) {
    EXPECT_NEAR(Ours(ball, {1e6, 0, 0, 1e5}, z) / Oracle(ball, {1e6, 0, 0, 1e5}, z, kOurs), 1, 1e-5)
        << z;
  }
}

// The nodes of the contact have the integral as their limit: their error falls with their spacing.
TEST(PlateLoad, IsTheLimitOfTheNodeSum) {
  for (const PrintedTire& printed : PrintedTires()) {
    Tire tire;
    tire.shape = printed.shape;
    for (const PrintedSpring& fit : printed.All()) {
      tire.spring = fit.spring;
      const double load = Ours(tire.shape, tire.spring, 0.1);
      EXPECT_NEAR(FlatPlateLoad(tire, 0.1, 0.025) / load, 1, 2e-3) << printed.name;
      EXPECT_NEAR(FlatPlateLoad(tire, 0.1, 0.002) / load, 1, 2e-5) << printed.name;
    }
  }
}

TEST(PlateLoad, IsLinearInTheTermsOfTheSpring) {
  const TireShape& shape = PrintedTires()[0].shape;
  const double sum = Ours(shape, {1e6, 0, 0, 0}, 0.07) + Ours(shape, {0, 2e6, 0, 0}, 0.07) +
                     Ours(shape, {0, 0, 3e6, 0}, 0.07) + Ours(shape, {0, 0, 0, 4e5}, 0.07);
  EXPECT_NEAR(Ours(shape, {1e6, 2e6, 3e6, 4e5}, 0.07) / sum, 1, 1e-12);
}

TEST(PlateArea, IsThatOfAnEllipseForASmallDeflection) {
  const TireShape& shape = PrintedTires()[0].shape;
  const double z = 1e-4;
  EXPECT_NEAR(
      FlatPlateArea(shape, z) / (2 * kPi * z * std::sqrt(shape.radius * shape.crown_radius)), 1,
      1e-3);
  const TireShape cylinder{0.47, INFINITY, 0.3};
  EXPECT_DOUBLE_EQ(FlatPlateArea(cylinder, 0.05), 0.6 * std::sqrt(0.47 * 0.47 - 0.42 * 0.42));
}

// r_beta = 8.43 in (4.2.2): the contact widths of 4.21 and 4.22 that an independent calculation
// gives [in]; 9.5 in, its greatest datum, lies at 1.466 in.
TEST(PlateWidth, FollowsEquations4_21And4_22) {
  for (const auto& [z, width] : {std::pair(0.75, 6.95), {1.0, 7.96}, {1.5, 9.60}, {2.5, 11.98}}) {
    EXPECT_NEAR(FlatPlateWidth(8.43, z), width, 0.006);
  }
  EXPECT_NEAR(FlatPlateWidth(8.43, 1.466), 9.5, 0.002);
}

// Loads [N] by an independent calculation in Python, to its five digits and more.
TEST(PlateLoadOracle, AgreesWithAnIndependentCalculation) {
  const auto expect = [](const PrintedTire& tire, const PrintedSpring& printed,
                         const PlateReading& reading, std::vector<double> loads) {
    for (int i = 0; i < 3; ++i) {
      const double z = 0.02 + 0.04 * i;
      EXPECT_NEAR(Oracle(tire.shape, printed.spring, z, reading) / loads[i], 1, 1e-5) << tire.name;
    }
  };
  const PrintedTire &soft = PrintedTires()[0], &hard = PrintedTires()[1], &wide = PrintedTires()[2];
  expect(soft, soft.linear, kPrinted, {996.0252, 10529.86, 27069.52});
  expect(soft, soft.quadratic, kPrinted, {651.1066, 8850.061, 28263.96});
  expect(soft, soft.linear_root, kPrinted, {2229.557, 13897.29, 27859.29});
  expect(soft, soft.root, kPrinted, {2468.824, 14484.76, 27790.13});
  expect(soft, soft.cubic, kPrinted, {606.6778, 8211.018, 26432.5});
  expect(hard, hard.linear, kPrinted, {1475.031, 15117.41, 41359.1});
  expect(hard, hard.root, kPrinted, {3488.797, 20073.36, 40910.02});
  expect(hard, hard.cubic, kPrinted, {2991.503, 24327.92, 41849.39});
  expect(wide, wide.linear, kPrinted, {1099.839, 10548.71, 31734.42});
  expect(wide, wide.root, kPrinted, {2568.372, 13993.73, 31255.4});
  expect(soft, soft.root, kBySymmetry, {3129.7, 15180, 27906.01});
  expect(hard, hard.linear, kBySymmetry, {1871.258, 16299.87, 41446.71});
  expect(wide, wide.root, kBySymmetry, {3255.854, 16380.69, 31789.82});
}

struct Band {
  double least, most;  // [N]  of the printed linear and root springs at 0.1 m, read as printed
};
constexpr Band kBands[] = {{26.4e3, 28.3e3}, {40.3e3, 41.8e3}, {31.1e3, 31.8e3}};
constexpr double kBeyond = 0.003;  // [-]  of the other three springs, which are no least squares

TEST(PrintedSprings, CarryTheSameLoadInThePrintedReading) {
  for (std::size_t i = 0; i < PrintedTires().size(); ++i) {
    const PrintedTire& tire = PrintedTires()[i];
    for (const PrintedSpring& printed : tire.All()) {
      const double load = Oracle(tire.shape, printed.spring, 0.1, kPrinted);
      EXPECT_GE(load, (1 - kBeyond) * kBands[i].least) << tire.name;
      EXPECT_LE(load, (1 + kBeyond) * kBands[i].most) << tire.name;
    }
    for (const PrintedSpring* usable : {&tire.linear, &tire.root}) {
      const double load = Oracle(tire.shape, usable->spring, 0.1, kPrinted);
      EXPECT_GE(load, kBands[i].least) << tire.name;
      EXPECT_LE(load, kBands[i].most) << tire.name;
    }
  }
}

// Ours [N] of the linear and the root springs at 0.1 m: one in its band, five up to 2.5 % below.
TEST(PrintedSprings, CarryLoadsInTheirBandsOrALittleBelow) {
  constexpr double kLoads[][2] = {{25783.4, 26957.6}, {39853.0, 40249.2}, {30561.5, 30755.0}};
  int inside = 0;
  for (std::size_t i = 0; i < PrintedTires().size(); ++i) {
    const PrintedTire& tire = PrintedTires()[i];
    for (int root : {0, 1}) {
      const double load = Ours(tire.shape, root == 0 ? tire.linear.spring : tire.root.spring, 0.1);
      EXPECT_NEAR(load, kLoads[i][root], 1) << tire.name;
      EXPECT_GT(load, 0.975 * kBands[i].least) << tire.name;
      EXPECT_LT(load, kBands[i].most) << tire.name;
      if (load >= kBands[i].least) ++inside;
    }
  }
  EXPECT_EQ(inside, 1);
}

// Ours carries 1 to 5 % less than the printed reading at 0.1 m, and more at small deflections,
// where that has the factor pi for 4. Only with the loaded area does the root spring of the 18.4R38
// carry the 26,950 N that 6.2.1 states; the readings without it are 1.7 to 5 % off.
TEST(PrintedSprings, CarryALittleLessWithTheLoadedArea) {
  for (const PrintedTire& tire : PrintedTires()) {
    for (const PrintedSpring* printed : {&tire.linear, &tire.root}) {
      const double ratio = Ours(tire.shape, printed->spring, 0.1) /
                           Oracle(tire.shape, printed->spring, 0.1, kPrinted);
      EXPECT_GT(ratio, 0.95) << tire.name;
      EXPECT_LT(ratio, 0.99) << tire.name;
    }
  }
  const PrintedTire& soft = PrintedTires()[0];
  EXPECT_NEAR(Ours(soft.shape, soft.root.spring, 0.1), 26950, 10);
  EXPECT_NEAR(Oracle(soft.shape, soft.root.spring, 0.1, kPrinted), 27790, 10);
  EXPECT_NEAR(Oracle(soft.shape, soft.root.spring, 0.1, kBySymmetry), 27906, 10);
}

}  // namespace
}  // namespace softsoil
