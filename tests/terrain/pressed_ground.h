// Circles of uniform pressure on flat ground, as loads of columns and of a whole ground.
#pragma once

#include <memory>
#include <vector>

#include "terrain/columns.h"
#include "terrain/ground.h"
#include "terrain/surface_load.h"
#include "tests/terrain/test_soil.h"

namespace softsoil {

struct Circle {
  GridNode centre;
  double radius;    // [m]
  double pressure;  // [Pa]
};

template <class Visit>
void ForEachNodeIn(const Circle& circle, double dx, const Visit& visit) {
  const int n = static_cast<int>(circle.radius / dx);
  for (int i = -n; i <= n; ++i) {
    for (int j = -n; j <= n; ++j) {
      if ((i * i + j * j) * dx * dx > circle.radius * circle.radius) continue;
      visit(GridNode{circle.centre.i + i, circle.centre.j + j});
    }
  }
}

inline SurfaceLoad LoadOf(const Circle& circle, double dx, int source = 0) {
  SurfaceLoad load;
  ForEachNodeIn(circle, dx, [&](GridNode node) {
    load.push_back({node, node.i * dx, node.j * dx, 0.0,
                    Eigen::Vector3d(0, 0, -circle.pressure * dx * dx), source});
  });
  return load;
}

inline std::vector<SurfaceForce> ForcesOf(const Circle& circle, double dx) {
  std::vector<SurfaceForce> forces;
  for (const NodeForce& f : LoadOf(circle, dx)) forces.push_back({{f.x, f.y, 0}, f.force_w});
  return forces;
}

inline double FlatGround(double, double) { return 0.0; }

inline GroundSettings CoarseGround(int volumes, bool sync) {
  GroundSettings settings;
  settings.grid_spacing = 0.05;
  settings.volume_height = 0.05;
  settings.volumes = volumes;
  settings.sync = sync;
  return settings;
}

inline Columns FlatColumns(const ColumnSettings& settings, int threads = 1) {
  const Soil soil = LooseSoil();
  return Columns(soil, settings, FlatGround,
                 MakeDirectStress({{soil.concentration_factor}, 1.25 * settings.spacing, threads}));
}

}  // namespace softsoil
