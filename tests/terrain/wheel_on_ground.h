// Wheels' forces on flat ground, on slopes and in ruts, and the columns below.
#pragma once

#include <functional>

#include "tests/terrain/stress_case.h"

namespace softsoil {

constexpr double kDx = 0.025;                     // [m]
constexpr double kSlope20 = 0.36397023426620234;  // tan(20 degrees)

using Height = std::function<double(double x, double y)>;  // [m]
using Force = std::function<Eigen::Vector3d(int i, int j)>;

struct StressCase {
  ColumnBatch batch;
  SurfaceLoad load;
};

inline double Flat(double, double) { return 0; }

// A rut 20 cm deep between berms, along x; its middle is y = 0.
inline double Rut(double, double y) {
  const double d = std::abs(y);
  if (d < 0.2) return -0.2;
  if (d < 0.3) return -0.2 + (d - 0.2) / 0.1 * 0.25;
  return std::max(0.05 - (d - 0.3) * 0.5, 0.0);
}

// Where a wheel 20 cm deep stands.
inline double Trench(double x, double) { return -0.2 + 0.15 * std::pow(x / 0.3, 2); }

inline double Slope(double x, double) { return kSlope20 * x; }
inline double SlopeAcross(double x, double y) { return kSlope20 * (0.6 * x - 0.8 * y); }

inline Eigen::Vector3d Pressing(int, int) { return {0, 0, -50}; }
inline Eigen::Vector3d Driving(int i, int j) { return {20.0 + i, 15.0 - j, -50}; }
// As much as friction may hold.
inline Eigen::Vector3d PushingAside(int, int) { return {24, -32, -50}; }
inline Eigen::Vector3d OfACircle(int i, int j) {
  return {0, 0, std::hypot(i, j) <= 9 ? -50.0 : 0.0};
}
// Without any order.
inline Eigen::Vector3d Rough(int i, int j) {
  const auto wave = [&](double a, double b) { return std::sin(a * i + b * j); };
  return {30 * wave(7, 3), 30 * wave(2, 11), -60 + 50 * wave(5, 13)};
}

// A wheel's forces on the nodes within `half` of a middle one.
inline void AddForces(GridNode middle, GridNode half, const Height& height, const Force& force,
                      StressCase* c) {
  for (int i = -half.i; i <= half.i; ++i) {
    for (int j = -half.j; j <= half.j; ++j) {
      const GridNode node{middle.i + i, middle.j + j};
      const double z = height(node.i * kDx, node.j * kDx);
      c->load.push_back(ForceAt(node, kDx, z, force(i, j)));
    }
  }
}

// Columns of 30 volumes, more or less compacted, below the nodes within `half` of a middle one.
inline void AddColumns(GridNode middle, GridNode half, const Height& height, StressCase* c) {
  c->batch.volumes = 30;
  std::mt19937 random(static_cast<unsigned>(middle.i + 1));
  std::uniform_real_distribution<double> share(0.75, 1);
  for (int i = middle.i - half.i; i <= middle.i + half.i; ++i) {
    for (int j = middle.j - half.j; j <= middle.j + half.j; ++j) {
      double z = height(i * kDx, j * kDx), pressure = 0;
      for (const NodeForce& f : c->load) {
        if (f.node.i == i && f.node.j == j) pressure -= f.force_w.z() / (kDx * kDx);
      }
      c->batch.x.push_back(i * kDx);
      c->batch.y.push_back(j * kDx);
      c->batch.surface_pressure.push_back(pressure);
      c->batch.soil.push_back(0);
      for (int k = 0; k < c->batch.volumes; ++k) {
        const double w = share(random) * kDx;
        c->batch.z.push_back(z - w / 2);
        z -= w;
      }
    }
  }
}

inline StressCase OneWheel(const Height& height, const Force& force) {
  StressCase c;
  AddForces({0, 0}, {9, 10}, height, force, &c);
  AddColumns({0, 0}, {20, 26}, height, &c);
  return c;
}

}  // namespace softsoil
