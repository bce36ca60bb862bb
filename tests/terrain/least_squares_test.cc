#include "terrain/least_squares.h"

#include <gmock/gmock.h>

#include <cmath>
#include <random>

#include "terrain/input_error.h"

namespace softsoil {
namespace {

using Eigen::Vector2d;
using Eigen::VectorXd;
using testing::HasSubstr;
using testing::ThrowsMessage;

// y = p_0 exp(-p_1 x), parameters of very different size.
VectorXd Decay(const VectorXd& p, const VectorXd& x) { return p[0] * (-p[1] * x.array()).exp(); }

Fit FitDecay(const VectorXd& x, const VectorXd& y) {
  return LeastSquares([&](const VectorXd& p) -> VectorXd { return Decay(p, x) - y; },
                      Vector2d(5e5, 0.5), Vector2d(1e6, 1), static_cast<int>(x.size()));
}

TEST(LeastSquares, RecoversTheParametersOfExactData) {
  const VectorXd x = VectorXd::LinSpaced(8, 0, 3);
  const Fit fit = FitDecay(x, Decay(Vector2d(1e6, 1.5), x));
  EXPECT_NEAR(fit.parameters[0], 1e6, 1e-6 * 1e6);
  EXPECT_NEAR(fit.parameters[1], 1.5, 1e-6 * 1.5);
  EXPECT_LT(fit.rms, 1e-3);
}

// For a straight line through the origin the textbook gives p = xy/xx, s^2 = rr/(n-1),
// se = s/sqrt(xx); t(0.975, 4) = 2.776445 (tables).
TEST(LeastSquares, GivesTheTextbookErrorsOfALine) {
  const VectorXd x = VectorXd::LinSpaced(5, 1, 5);
  VectorXd y(5);
  y << 2.1, 3.9, 6.2, 7.8, 10.1;
  const Fit fit = LeastSquares([&](const VectorXd& p) -> VectorXd { return p[0] * x - y; },
                               VectorXd::Ones(1), VectorXd::Ones(1), 5);
  const double slope = x.dot(y) / x.squaredNorm();
  const double error = std::sqrt((slope * x - y).squaredNorm() / 4 / x.squaredNorm());
  EXPECT_NEAR(fit.parameters[0], slope, 1e-9);
  EXPECT_NEAR(fit.standard_error[0], error, 1e-6 * error);
  EXPECT_NEAR(fit.confidence[0], 2.776445 * error, 1e-5 * error);
}

// Of many noisy experiments about 95 % must cover the truth.
TEST(LeastSquares, IntervalsCoverTheTruthAsOftenAsTheySay) {
  std::mt19937 random(1);
  std::normal_distribution<double> noise(0, 1e4);
  const VectorXd x = VectorXd::LinSpaced(12, 0, 3);
  int covered = 0;
  constexpr int kExperiments = 400;
  for (int k = 0; k < kExperiments; ++k) {
    VectorXd y = Decay(Vector2d(1e6, 1.5), x);
    for (double& value : y) value += noise(random);
    const Fit fit = FitDecay(x, y);
    covered += std::abs(fit.parameters[1] - 1.5) <= fit.confidence[1] ? 1 : 0;
  }
  EXPECT_GT(covered, 0.92 * kExperiments);
  EXPECT_LT(covered, 0.98 * kExperiments);
}

TEST(LeastSquares, FindsAParameterThatIsZero) {
  const VectorXd x = VectorXd::LinSpaced(8, 0, 3);
  const Fit fit = FitDecay(x, VectorXd::Constant(8, 2e5));
  EXPECT_NEAR(fit.parameters[0], 2e5, 1e-6 * 2e5);
  EXPECT_NEAR(fit.parameters[1], 0, 1e-6);
}

TEST(LeastSquares, ClaimsNoConfidenceWithoutADegreeOfFreedom) {
  const VectorXd x = VectorXd::LinSpaced(2, 0, 1);
  const Fit fit = FitDecay(x, Decay(Vector2d(1e6, 1.5), x));
  EXPECT_TRUE(std::isinf(fit.standard_error[0]));
  EXPECT_TRUE(std::isinf(fit.confidence[1]));
}

TEST(LeastSquares, RefusesDataThatDoNotDetermineTheParameters) {
  const VectorXd x = VectorXd::Constant(5, 1.0);
  EXPECT_THAT([&] { FitDecay(x, x); },
              ThrowsMessage<InputError>(HasSubstr("do not determine all 2 parameters")));
  EXPECT_THAT(
      [&] { FitDecay(x.head(1), x.head(1)); },
      ThrowsMessage<InputError>(HasSubstr("at least as many rows as parameters, 2, got 1")));
}

}  // namespace
}  // namespace softsoil
