#include "tests/reference/plate_load_oracle.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr int kPoints = 64;

struct Rule {
  std::vector<double> point, weight;  // on [-1, 1]
};

// Roots of the Legendre polynomial by Newton's method.
Rule LegendreRule() {
  Rule rule;
  for (int i = 0; i < kPoints; ++i) {
    double x = std::cos(kPi * (i + 0.75) / (kPoints + 0.5)), slope = 0;
    for (int iteration = 0; iteration < 100; ++iteration) {
      double p = 1, last = 0;
      for (int k = 0; k < kPoints; ++k) {
        const double next = ((2 * k + 1) * x * p - k * last) / (k + 1);
        last = p;
        p = next;
      }
      slope = kPoints * (x * p - last) / (x * x - 1);
      const double step = p / slope;
      x -= step;
      if (std::abs(step) < 1e-16) break;
    }
    rule.point.push_back(x);
    rule.weight.push_back(2 / ((1 - x * x) * slope * slope));
  }
  return rule;
}

// The integral from a to b; the end b may be one where f begins like a root.
double Integral(const std::function<double(double)>& f, double a, double b) {
  static const Rule rule = LegendreRule();
  double sum = 0;
  for (int i = 0; i < kPoints; ++i) {
    const double u = (1 + rule.point[i]) / 2;  // x = b - (b - a)(1 - u)^2
    sum += rule.weight[i] / 2 * f(b - (b - a) * (1 - u) * (1 - u)) * 2 * (1 - u) * (b - a);
  }
  return sum;
}

}  // namespace

double PlateLoadOracle(double r, double r_beta, double b,
                       const std::function<double(double)>& pressure, double z,
                       const PlateReading& reading) {
  const auto element = [&](double theta, double beta) {
    const double drop = r_beta * (1 - std::cos(beta));
    const double d = r - (r - z) / std::cos(theta) - drop;
    if (d <= 0) return 0.0;
    double area = reading.exact_area ? r_beta * (r - drop) : r * r_beta;
    if (reading.loaded_area) area *= (r - drop - d) / (r - drop);
    const double cosines = std::cos(theta) * std::cos(beta);
    return pressure(d) * area * (reading.squared_cosines ? cosines * cosines : cosines);
  };
  const double widest = std::asin(b / (2 * r_beta));
  // Where the contact ends across the tread at the angle theta.
  const auto end = [&](double theta) {
    const double drop = r - (r - z) / std::cos(theta);
    return std::acos(std::max(-1.0, 1 - std::max(0.0, drop) / r_beta));
  };
  const double theta_max = std::acos((r - z) / r);
  const double cosine = (r - z) / (r - r_beta * (1 - std::cos(widest)));
  const double theta_12 = cosine < 1 ? std::acos(cosine) : 0;  // 4.24
  const auto across = [&](double theta) {
    const double last = std::min(widest, end(theta));
    return Integral([&](double beta) { return element(theta, beta); }, 0, last);
  };
  return 4 * Integral(across, 0, theta_12) +
         reading.ellipse * Integral(across, theta_12, theta_max);
}
