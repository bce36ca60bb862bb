#include "terrain/gaussian_law.h"

#include <Eigen/Dense>
#include <cmath>

#include "terrain/constants.h"

namespace softsoil {
namespace {

constexpr float kNarrowest = 0.42f;  // of the depth: least width of the narrowest Gaussian
constexpr int kEntries = 16;

// Weights of the Gaussians of L^2 = 2^(k / 2) narrowest_square whose sum comes closest to `law`, a
// function of r / z that is zero outside the cone. It counts how far the sum is off at a point, and
// over the circle inside that point, for loads cover areas; most of all over the whole plane, for
// the load of a wide area.
template <class Law>
Eigen::VectorXd Fit(double narrowest_square, const Law& law) {
  constexpr int kPoints = 200, kPointsInCone = 80;  // so that the law jumps between two of them
  constexpr double kWholePlane = 5;
  const double step = law.Edge() / kPointsInCone;
  Eigen::MatrixXd matrix(2 * kPoints + 1, kGaussians);
  Eigen::VectorXd target(2 * kPoints + 1);
  Eigen::RowVectorXd inside = Eigen::RowVectorXd::Zero(kGaussians);
  double target_inside = 0;
  for (int i = 0; i < kPoints; ++i) {
    const double r = (i + 0.5) * step;
    Eigen::RowVectorXd gaussians(kGaussians);
    for (int k = 0; k < kGaussians; ++k) {
      gaussians[k] = law.Shape(r) * std::exp(-r * r / (narrowest_square * std::exp2(0.5 * k)));
    }
    const double weight = std::sqrt(r * step), ring = law.Ring(r) * step;
    inside += ring * gaussians;
    target_inside += ring * law(r);
    matrix.row(2 * i) = weight * gaussians;
    target[2 * i] = weight * law(r);
    matrix.row(2 * i + 1) = std::sqrt(step) * inside;
    target[2 * i + 1] = std::sqrt(step) * target_inside;
  }
  matrix.row(2 * kPoints) = kWholePlane * inside;
  target[2 * kPoints] = kWholePlane * target_inside;
  return matrix.colPivHouseholderQr().solve(target);
}

// Stress at depth 1 of a unit force.
struct Vertical {
  double nu;
  double Edge() const { return std::sqrt(nu + 1); }
  double operator()(double r) const {
    return r <= Edge() ? nu / (2 * kPi) * std::pow(1 + r * r, -(nu + 2) / 2) : 0.0;
  }
  static double Shape(double) { return 1; }
  static double Ring(double r) { return 2 * kPi * r; }
};
struct Horizontal {
  double nu;
  double Edge() const { return std::sqrt(nu + 1); }
  double operator()(double r) const {
    return r <= Edge() ? 3 / (2 * kPi) * r * std::pow(1 + r * r, -2.5) : 0.0;
  }
  static double Shape(double r) { return r; }
  static double Ring(double r) { return 2 * r; }
};

}  // namespace

GaussianLaw::GaussianLaw(double nu) : cone_(static_cast<float>(std::sqrt(nu + 1))) {
  for (int i = 0; i <= kEntries; ++i) {
    const double mantissa = 0.5 + 0.5 * i / kEntries;
    const double narrowest_square = kNarrowest * kNarrowest / std::sqrt(mantissa);
    const Eigen::VectorXd vertical = Fit(narrowest_square, Vertical{nu});
    const Eigen::VectorXd horizontal = Fit(narrowest_square, Horizontal{nu});
    Entry entry;
    for (int k = 0; k < kGaussians; ++k) {
      entry.weight[k] = static_cast<float>(vertical[k]);
      entry.weight[kGaussians + k] = static_cast<float>(horizontal[k]);
    }
    entries_.push_back(entry);
  }
}

GaussianSum GaussianLaw::At(float depth) const {
  GaussianSum sum;
  // The narrowest Gaussian has L^4 = 2^first >= (kNarrowest depth)^4.
  const float least_square = kNarrowest * kNarrowest * depth * depth;
  const float mantissa = std::frexp(least_square * least_square, &sum.first);
  const float place = (mantissa - 0.5f) * (2 * kEntries);
  const int i = static_cast<int>(place);
  const float share = place - i;
  const float inverse2 = 1 / (depth * depth), inverse3 = inverse2 / depth;
  for (int k = 0; k < kGaussians; ++k) {
    const auto weight = [&](int of) {
      return entries_[i].weight[of] + share * (entries_[i + 1].weight[of] - entries_[i].weight[of]);
    };
    sum.vertical[k] = inverse2 * weight(k);
    sum.horizontal[k] = inverse3 * weight(kGaussians + k);
  }
  return sum;
}

}  // namespace softsoil
