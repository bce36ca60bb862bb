#include "terrain/nurbs_bumps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace softsoil {
namespace {

constexpr double kLeastWeight = 0.5, kMostWeight = 2;

// A bijection that changes half of the bits if one changes: the finalizer of SplitMix64; Steele,
// Lea and Flood, Fast Splittable Pseudorandom Number Generators (2014).
std::uint64_t Scattered(std::uint64_t bits) {
  bits += 0x9e3779b97f4a7c15;
  bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9;
  bits = (bits ^ (bits >> 27)) * 0x94d049bb133111eb;
  return bits ^ (bits >> 31);
}

// In (0, 1), symmetric about 0.5.
double Fraction(std::uint32_t bits) { return (bits + 0.5) / 4294967296.0; }

struct ControlPoint {
  double height;  // [-]  of the highest, -1 to 1
  double weight;
};

// `row` is the scattered number of the row of points with the same i.
ControlPoint ControlPointAt(std::uint64_t row, std::int64_t j) {
  const std::uint64_t bits = Scattered(row ^ static_cast<std::uint64_t>(j));
  const double share = Fraction(static_cast<std::uint32_t>(bits));
  return {2 * Fraction(static_cast<std::uint32_t>(bits >> 32)) - 1,
          kLeastWeight + (kMostWeight - kLeastWeight) * share};
}

// [-]  Farther out a double no longer tells one control point from the next.
constexpr double kFarthest = 9007199254740992;

// A place on the axis of a uniform cubic B-spline, whose knots are the integers.
struct SplinePlace {
  explicit SplinePlace(double anywhere) {
    const double u = std::clamp(anywhere, -kFarthest, kFarthest);
    first = static_cast<std::int64_t>(std::floor(u)) - 1;
    const double t = u - std::floor(u), s = 1 - t;
    share = {s * s * s / 6, (4 - 3 * t * t * (2 - t)) / 6, (4 - 3 * s * s * (2 - s)) / 6,
             t * t * t / 6};
  }
  std::int64_t first;           // of the four control points that count
  std::array<double, 4> share;  // [-]  of each; their sum is 1
};

}  // namespace

double HeightOf(const NurbsBumps& bumps, double x, double y) {
  const SplinePlace along_x(x / bumps.spacing), along_y(y / bumps.spacing);
  const std::uint64_t origin = Scattered(bumps.seed);
  double sum = 0, weights = 0;
  for (int a = 0; a < 4; ++a) {
    const std::uint64_t row = Scattered(origin ^ static_cast<std::uint64_t>(along_x.first + a));
    for (int b = 0; b < 4; ++b) {
      const ControlPoint point = ControlPointAt(row, along_y.first + b);
      const double weight = along_x.share[a] * along_y.share[b] * point.weight;
      sum += weight * point.height;
      weights += weight;
    }
  }
  return bumps.height * (sum / weights);
}

UndisturbedHeight WithBumps(UndisturbedHeight ground, const NurbsBumps& bumps) {
  if (bumps.height == 0) return ground;
  return [ground = std::move(ground), bumps](double x, double y) {
    return ground(x, y) + HeightOf(bumps, x, y);
  };
}

}  // namespace softsoil
