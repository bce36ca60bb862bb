#include "plugin/cli/centre_line.h"

#include <gmock/gmock.h>

#include <limits>

#include "terrain/constants.h"

namespace softsoil {
namespace {

constexpr double kSpacing = 0.05;  // [m]  of nodes along and across

// A cylinder with so many rings, whose nodes stand `pitch` [deg] apart.
TireNodes Nodes(int rings, double pitch) {
  const double radius = kSpacing * 360 / pitch / (2 * kPi);
  return MakeTireNodes({radius, std::numeric_limits<double>::infinity(), rings * kSpacing},
                       kSpacing);
}

softsoilContact At(double degrees, double lateral, double pressure, double shear = 0) {
  softsoilContact contact = {};
  contact.angle = degrees / kDegrees;
  contact.lateral = lateral;
  contact.pressure = pressure;
  contact.shear = shear;
  return contact;
}

// Stress of the line at an angle [deg]; none where it has no point.
CentreLinePoint PointAt(double angle, const CentreLine& line) {
  for (const CentreLinePoint& point : line.Points()) {
    if (std::abs(point.angle - angle) < 1e-9) return point;
  }
  return {angle, 0, 0};
}
double PressureAt(double angle, const CentreLine& line) { return PointAt(angle, line).pressure; }

constexpr double kRounding = 1e-9;  // [Pa]

TEST(CentreLine, IsTheMiddleRing) {
  CentreLine line(Nodes(3, 1));
  line.Add({At(10.5, 0, 80, 20), At(10.5, 0.05, 50, 10), At(-3.5, 0, 70, -5)});
  EXPECT_NEAR(PressureAt(10.5, line), 80, kRounding);
  EXPECT_NEAR(PointAt(10.5, line).shear, 20, kRounding);
  EXPECT_NEAR(PointAt(-3.5, line).shear, -5, kRounding);
  EXPECT_LT(line.Points().front().angle, line.Points().back().angle);
}

TEST(CentreLine, IsNeverAnOuterRing) {
  CentreLine line(Nodes(3, 1));
  line.Add({At(10.5, 0.05, 50)});
  EXPECT_TRUE(line.Points().empty());
}

TEST(CentreLine, IsTheMeanOfTheTwoRingsBesideTheMiddle) {
  CentreLine line(Nodes(4, 1));
  line.Add({At(0.5, 0.025, 80, 20), At(0.5, -0.025, 60, 10), At(0.5, 0.075, 9, 9)});
  EXPECT_NEAR(PressureAt(0.5, line), 70, kRounding);
  EXPECT_NEAR(PointAt(0.5, line).shear, 15, kRounding);

  CentreLine one_side(Nodes(4, 1));
  one_side.Add({At(0.5, 0.025, 80)});
  EXPECT_NEAR(PressureAt(0.5, one_side), 40, kRounding);
}

TEST(CentreLine, IsTheMeanOfInstantsAndNotOfThoseThatTouchAlone) {
  CentreLine line(Nodes(1, 1));
  line.Add({At(0.5, 0, 80), At(1.5, 0, 60)});
  line.Add({At(0.5, 0, 90)});
  line.Add({});
  line.Add({At(0.5, 0, 70)});
  EXPECT_NEAR(PressureAt(0.5, line), 60, kRounding);
  EXPECT_NEAR(PressureAt(1.5, line), 15, kRounding);
}

TEST(CentreLine, IsLinearFromNodeToNodeAndToTheNextThatDoesNotTouch) {
  CentreLine line(Nodes(1, 5));
  line.Add({At(0.5, 0, 100), At(5.5, 0, 50)});
  EXPECT_NEAR(PressureAt(0.5, line), 100, kRounding);
  EXPECT_NEAR(PressureAt(2.5, line), 80, kRounding);
  EXPECT_NEAR(PressureAt(7.5, line), 30, kRounding);
  EXPECT_NEAR(PressureAt(10.5, line), 0, kRounding);
  EXPECT_NEAR(PressureAt(-1.5, line), 60, kRounding);
}

// Wherever the nodes stand, as much as every node's pressure on its stretch of the circumference.
TEST(CentreLine, OfATurningWheelHoldsThePressureOfItsNodes) {
  constexpr int kPitch = 4, kInstants = 100;
  CentreLine line(Nodes(1, kPitch));
  double expected = 0, found = 0;  // [Pa deg]
  for (int t = 0; t < kInstants; ++t) {
    std::vector<softsoilContact> contacts;
    for (double angle = -40 + kPitch * t / 100.0; angle < 60; angle += kPitch) {
      if (std::abs(angle) <= 10.3) contacts.push_back(At(angle, 0, 90));
    }
    expected += 90.0 * kPitch * contacts.size() / kInstants;
    line.Add(contacts);
  }
  for (const CentreLinePoint& point : line.Points()) {
    EXPECT_LE(point.pressure, 90 + kRounding);
    found += point.pressure;
  }
  EXPECT_NEAR(found, expected, 1e-9 * expected);
  EXPECT_LT(line.Points().front().pressure, 10);  // where few nodes touch, and those rarely
}

TEST(CentreLine, IsEmptyInTheAir) {
  CentreLine line(Nodes(1, 1));
  line.Add({});
  EXPECT_TRUE(line.Points().empty());
}

TEST(CentreLine, HasNoPointsWithoutRings) {
  CentreLine line(TireNodes{});
  line.Add({At(0, 0, 1000)});
  EXPECT_TRUE(line.Points().empty());
}

}  // namespace
}  // namespace softsoil
