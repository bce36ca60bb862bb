#include "plugin/cli/centre_line.h"

#include <gmock/gmock.h>

#include "terrain/constants.h"

namespace softsoil {
namespace {

softsoilContact At(double degrees, double lateral, double pressure, double shear) {
  softsoilContact contact = {};
  contact.angle = degrees * kPi / 180;
  contact.lateral = lateral;
  contact.pressure = pressure;
  contact.shear = shear;
  return contact;
}

TEST(CentreLine, IsTheMiddleRing) {
  CentreLine line;
  line.Add({At(10.5, 0, 80, 20), At(10.5, 0.02, 50, 10), At(-3.5, 0, 70, -5)});
  const std::vector<CentreLinePoint> points = line.Points();
  ASSERT_EQ(points.size(), 2);
  EXPECT_NEAR(points[0].angle, -3.5, 1e-12);
  EXPECT_EQ(points[0].shear, -5);
  EXPECT_EQ(points[1].pressure, 80);
}

TEST(CentreLine, IsTheMeanOfTheTwoRingsBesideTheMiddle) {
  CentreLine line;
  line.Add({At(0.5, 0.01, 80, 20), At(0.5, -0.01, 60, 10), At(0.5, 0.03, 0, 0)});
  ASSERT_EQ(line.Points().size(), 1);
  EXPECT_EQ(line.Points()[0].pressure, 70);
  EXPECT_EQ(line.Points()[0].shear, 15);
}

TEST(CentreLine, IsTheMeanOfManyInstants) {
  CentreLine line;
  line.Add({At(0.2, 0, 80, 0)});
  line.Add({At(0.6, 0, 90, 0)});
  ASSERT_EQ(line.Points().size(), 1);
  EXPECT_NEAR(line.Points()[0].angle, 0.4, 1e-12);
  EXPECT_EQ(line.Points()[0].pressure, 85);
}

TEST(CentreLine, IsEmptyInTheAir) {
  CentreLine line;
  line.Add({});
  EXPECT_TRUE(line.Points().empty());
}

}  // namespace
}  // namespace softsoil
