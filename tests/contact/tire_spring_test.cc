#include "contact/tire_spring.h"

#include <gtest/gtest.h>

namespace softsoil {
namespace {

// One of each form, and one of all terms.
constexpr TireSpring kSprings[] = {
    {1.314e6, 0, 0, 0},       {7.433e5, 8.63e6, 0, 0}, {6.991e5, 7.445e6, 7.29e6, 0},
    {2.289e5, 0, 0, 2.889e5}, {0, 0, 0, 3.469e5},      {1e5, 2e6, 3e6, 4e5}};

TEST(TireSpring, PressesOnlyWhenPressed) {
  for (const TireSpring& spring : kSprings) {
    EXPECT_EQ(SpringPressure(spring, 0), 0);
    EXPECT_EQ(SpringPressure(spring, -0.1), 0);
    EXPECT_GT(SpringPressure(spring, 1e-9), 0);
  }
}

TEST(TireSpring, StiffensWithPenetration) {
  for (const TireSpring& spring : kSprings) {
    for (double d = 0.001; d < 0.5; d += 0.001) {
      EXPECT_GT(SpringPressure(spring, d), SpringPressure(spring, d - 0.001));
    }
  }
}

TEST(TireSpring, IsTheSumOfItsTerms) {
  EXPECT_EQ(SpringPressure({2e6, 0, 0, 0}, 0.04), 8e4);
  EXPECT_DOUBLE_EQ(SpringPressure({0, 2e6, 0, 0}, 0.04), 3200);
  EXPECT_DOUBLE_EQ(SpringPressure({0, 0, 2e6, 0}, 0.04), 128);
  EXPECT_EQ(SpringPressure({0, 0, 0, 2e6}, 0.04), 4e5);
  EXPECT_DOUBLE_EQ(SpringPressure({2e6, 2e6, 2e6, 2e6}, 0.04), 8e4 + 3200 + 128 + 4e5);
}

TEST(TireSpring, HasTheSlopeOfItsPressure) {
  const double e = 1e-7;
  for (const TireSpring& spring : kSprings) {
    for (double d : {0.001, 0.02, 0.1, 0.4}) {
      const double difference = SpringPressure(spring, d + e) - SpringPressure(spring, d - e);
      EXPECT_NEAR(SpringSlope(spring, d) / (difference / (2 * e)), 1, 1e-6) << d;
    }
  }
}

}  // namespace
}  // namespace softsoil
