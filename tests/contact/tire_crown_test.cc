// The crown radius from contact widths, with and without a tread that they reach.
#include "contact/tire_crown.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "terrain/input_error.h"

namespace softsoil {
namespace {

constexpr double kNoTread = std::numeric_limits<double>::infinity();

struct Widths {
  std::vector<double> deflection, width;  // [m]
};

// Equations 4.21 and 4.22 from 2 to 12 cm, cut off at the tread.
Widths WidthsOf(double crown, double tread, int rows, double noise = 0, unsigned seed = 1) {
  Widths widths;
  std::mt19937 random(seed);
  std::normal_distribution<double> error(0, 1);
  for (int i = 0; i < rows; ++i) {
    const double z = 0.02 + 0.1 * i / (rows - 1);
    const double width = std::min(tread, 2 * crown * std::sin(std::acos((crown - z) / crown)));
    widths.deflection.push_back(z);
    widths.width.push_back(width * (1 + noise * error(random)));
  }
  return widths;
}

CrownFit Fitted(const Widths& widths) { return FitCrownRadius(widths.deflection, widths.width); }

TEST(CrownRadius, IsRecoveredFromContactWidths) {
  for (double crown : {0.3, 0.661, 2.0}) {
    const CrownFit exact = Fitted(WidthsOf(crown, kNoTread, 11));
    EXPECT_NEAR(exact.crown_radius / crown, 1, 1e-9);
    EXPECT_LT(exact.rms, 1e-9);
    EXPECT_EQ(exact.plateau, kNoTread);
    const CrownFit fit = Fitted(WidthsOf(crown, kNoTread, 11, 0.02, 3));
    EXPECT_NEAR(fit.crown_radius / crown, 1, 0.05);
    EXPECT_LT(std::abs(fit.crown_radius - crown), 2 * fit.confidence);
    EXPECT_NEAR(fit.rms, 0.02 * 0.6 * std::sqrt(crown), 0.02 * 0.6 * std::sqrt(crown));
  }
}

// Treads that 3, 5 and 8 of 12 rows do not reach.
TEST(CrownRadius, IsRecoveredFromAContactAsWideAsTheTread) {
  for (double tread : {0.46, 0.535, 0.67}) {
    const CrownFit fit = Fitted(WidthsOf(0.661, tread, 12));
    EXPECT_NEAR(fit.crown_radius, 0.661, 1e-9) << tread;
    EXPECT_NEAR(fit.plateau, tread, 1e-12);
    EXPECT_LT(fit.rms, 1e-9);
  }
}

TEST(CrownRadius, IsRecoveredFromANoisyContactAsWideAsTheTread) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const CrownFit fit = Fitted(WidthsOf(0.661, 0.535, 12, 0.01, seed));
    EXPECT_NEAR(fit.crown_radius / 0.661, 1, 0.05) << seed;
    EXPECT_NEAR(fit.plateau / 0.535, 1, 0.01) << seed;
    EXPECT_LT(std::abs(fit.crown_radius - 0.661), 2 * fit.confidence) << seed;
  }
}

// One in a hundred may, by chance.
TEST(CrownRadius, SeesNoPlateauInNoise) {
  int plateaus = 0;
  for (unsigned seed = 1; seed <= 200; ++seed) {
    const CrownFit fit = Fitted(WidthsOf(0.661, kNoTread, 12, 0.02, seed));
    plateaus += std::isfinite(fit.plateau) ? 1 : 0;
    EXPECT_NEAR(fit.crown_radius / 0.661, 1, 0.05) << seed;
  }
  EXPECT_LE(plateaus, 10);
}

TEST(CrownRadius, DoesNotDependOnTheOrderOfRows) {
  Widths widths = WidthsOf(0.661, 0.535, 12, 0.01);
  const CrownFit fit = Fitted(widths);
  std::reverse(widths.deflection.begin(), widths.deflection.end());
  std::reverse(widths.width.begin(), widths.width.end());
  const CrownFit turned = Fitted(widths);
  EXPECT_EQ(turned.crown_radius, fit.crown_radius);
  EXPECT_EQ(turned.plateau, fit.plateau);
}

TEST(CrownRadius, IsNotToldByAContactThatIsAlwaysAsWideAsTheTread) {
  EXPECT_THROW(Fitted(WidthsOf(0.661, 0.3, 12)), InputError);                     // all rows
  EXPECT_THROW(Fitted(WidthsOf(0.661, 0.35, 12)), InputError);                    // all but one
  EXPECT_THROW(Fitted(WidthsOf(0.661, 0.3, 2)), InputError);                      // both rows
  EXPECT_THROW(FitCrownRadius({0.02, 0.04, 0.06}, {0.4, 0.3, 0.2}), InputError);  // falling
  for (unsigned seed = 1; seed <= 20; ++seed) {
    EXPECT_THROW(Fitted(WidthsOf(0.661, 0.3, 12, 0.01, seed)), InputError) << seed;
  }
}

}  // namespace
}  // namespace softsoil
