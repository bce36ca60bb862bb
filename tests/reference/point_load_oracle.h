// Vertical stress under forces on the surface of a half-space, in double, pair by pair. Shares
// nothing with the code that it judges.
#pragma once

#include <vector>

namespace softsoil_reference {

struct Point {
  double x, y, z;  // [m]  z up
};

struct Force {
  Point at;
  double x, y, z;  // [N]  on the ground; pressing is z < 0
};

// Froehlich (Madsen 2014, equation 3.12) and Cerruti (2.35) [Pa], compression positive, of one
// force; zero at and above its height.
double StressOf(const Force& force, double nu, const Point& point);

// The sum over the forces whose cone r^2 <= (nu + 1) z^2 holds the point (algorithm 3.2.2).
double StressInCones(const std::vector<Force>& forces, double nu, const Point& point);

// The sum over all forces.
double StressOfAll(const std::vector<Force>& forces, double nu, const Point& point);

// Stress [Pa] in the depth z [m] under the centre of a circle of radius a [m] loaded uniformly by
// p [Pa]: p (1 - cos^nu(alpha)), tan(alpha) = a / z. The integral of Froehlich's law.
double StressUnderCircle(double p, double nu, double a, double z);

// Share of a vertical force that passes a horizontal plane inside the cone r^2 <= (nu + 1) z^2:
// 1 - cos^nu of its half angle.
double ShareInsideCone(double nu);

}  // namespace softsoil_reference
