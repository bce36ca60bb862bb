// Loads and columns for tests of the stress field, for the code and for the oracle alike.
#pragma once

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "terrain/stress_field.h"
#include "tests/reference/point_load_oracle.h"

namespace softsoil {

inline std::vector<softsoil_reference::Force> ForOracle(const SurfaceLoad& load) {
  std::vector<softsoil_reference::Force> forces;
  for (const NodeForce& f : load) {
    forces.push_back({{f.x, f.y, f.z}, f.force_w.x(), f.force_w.y(), f.force_w.z()});
  }
  return forces;
}

// One force at a grid node.
inline NodeForce ForceAt(GridNode node, double dx, double z, const Eigen::Vector3d& force_w) {
  return {node, node.i * dx, node.j * dx, z, force_w, 0};
}

// Forces in all directions, pressing on the whole, on n x n nodes from `corner` on, at heights up
// to `relief` [m] apart.
inline SurfaceLoad RandomLoad(GridNode corner, int n, double dx, double relief, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(-1, 1);
  SurfaceLoad load;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      const Eigen::Vector3d force(40 * unit(random), 40 * unit(random), -60 + 50 * unit(random));
      const double z = relief / 2 * unit(random);
      load.push_back(ForceAt({corner.i + i, corner.j + j}, dx, z, force));
    }
  }
  return load;
}

// Volumes of height w below the height `top` at n x n nodes from `corner` on.
inline ColumnBatch Block(GridNode corner, int n, double dx, int volumes, double w, double top) {
  ColumnBatch batch;
  batch.volumes = volumes;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      batch.x.push_back((corner.i + i) * dx);
      batch.y.push_back((corner.j + j) * dx);
      batch.surface_pressure.push_back(0);
      batch.soil.push_back(0);
      for (int k = 0; k < volumes; ++k) batch.z.push_back(top - (k + 0.5) * w);
    }
  }
  return batch;
}

inline std::vector<float> Stress(const StressSettings& settings, const ColumnBatch& batch,
                                 const SurfaceLoad& load) {
  std::vector<float> stress;
  MakeDirectStress(settings)->VerticalStress(batch, load, &stress);
  return stress;
}

// The same by the oracle; no near field.
inline std::vector<double> OracleStress(double nu, const ColumnBatch& batch,
                                        const SurfaceLoad& load) {
  const auto forces = ForOracle(load);
  std::vector<double> stress;
  for (std::size_t column = 0; column < batch.columns(); ++column) {
    for (int k = 0; k < batch.volumes; ++k) {
      const double z = batch.z[column * batch.volumes + k];
      stress.push_back(
          softsoil_reference::StressInCones(forces, nu, {batch.x[column], batch.y[column], z}));
    }
  }
  return stress;
}

}  // namespace softsoil
