#include "terrain/soil_clock.h"

#include <gtest/gtest.h>

#include <vector>

namespace softsoil {
namespace {

// Lengths of the periods [s] in `steps` steps of h.
std::vector<double> Periods(double period, double h, int steps) {
  SoilClock clock(period);
  std::vector<double> lengths;
  for (int i = 0; i < steps; ++i) {
    if (!clock.Pass(h)) continue;
    lengths.push_back(clock.Elapsed());
    clock.Restart();
  }
  return lengths;
}

TEST(SoilClock, TicksOncePerPeriod) {
  const std::vector<double> lengths = Periods(0.01, 0.001, 10000);
  ASSERT_EQ(lengths.size(), 1000u);
  for (double length : lengths) EXPECT_NEAR(length, 0.01, 1e-12);
}

TEST(SoilClock, TicksAtTheNearestStepWhereTheStepDoesNotDivideThePeriod) {
  for (double h : {0.0003, 0.0007, 0.003, 0.004, 0.006}) {
    const std::vector<double> lengths = Periods(0.01, h, 1000);
    ASSERT_GT(lengths.size(), 10u);
    for (double length : lengths) EXPECT_NEAR(length, 0.01, h / 2 + 1e-12) << h;
  }
}

TEST(SoilClock, LosesNoTime) {
  double sum = 0;
  for (double length : Periods(0.01, 0.003, 999)) sum += length;
  EXPECT_NEAR(sum, 2.997, 1e-9);
}

TEST(SoilClock, TicksAtEveryStepThatIsLongerThanThePeriod) {
  EXPECT_EQ(Periods(0.01, 0.025, 8), std::vector<double>(8, 0.025));
}

}  // namespace
}  // namespace softsoil
