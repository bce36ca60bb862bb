#include "tests/reference/point_load_oracle.h"

#include <cmath>

namespace softsoil_reference {
namespace {

const double kPi = std::acos(-1.0);

bool InCone(const Force& force, double nu, const Point& point) {
  const double depth = force.at.z - point.z;
  const double r = std::hypot(point.x - force.at.x, point.y - force.at.y);
  return depth > 0 && r <= depth * std::sqrt(nu + 1);
}

}  // namespace

double StressOf(const Force& force, double nu, const Point& point) {
  const double depth = force.at.z - point.z;
  if (depth <= 0) return 0;
  const double dx = point.x - force.at.x, dy = point.y - force.at.y;
  const double R = std::hypot(dx, dy, depth);
  const double froehlich = -nu * force.z / (2 * kPi) * std::pow(depth, nu) / std::pow(R, nu + 2);
  const double cerruti =
      3 / (2 * kPi) * (force.x * dx + force.y * dy) * depth * depth / std::pow(R, 5);
  return froehlich + cerruti;
}

double StressInCones(const std::vector<Force>& forces, double nu, const Point& point) {
  double sum = 0;
  for (const Force& force : forces) {
    if (InCone(force, nu, point)) sum += StressOf(force, nu, point);
  }
  return sum;
}

double StressOfAll(const std::vector<Force>& forces, double nu, const Point& point) {
  double sum = 0;
  for (const Force& force : forces) sum += StressOf(force, nu, point);
  return sum;
}

double StressUnderCircle(double p, double nu, double a, double z) {
  return p * (1 - std::pow(z / std::hypot(a, z), nu));
}

double ShareInsideCone(double nu) { return 1 - std::pow(nu + 2, -nu / 2); }

}  // namespace softsoil_reference
