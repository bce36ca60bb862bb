#include "terrain/surface_load.h"

#include <cmath>

namespace softsoil {

void LoadGatherer::Add(const SurfaceForce& force, double h) {
  const double gx = force.point_w.x() / spacing_, gy = force.point_w.y() / spacing_;
  const double i = std::floor(gx), j = std::floor(gy);
  const double u = gx - i, v = gy - j;
  const GridNode node{static_cast<int>(i), static_cast<int>(j)};
  const Eigen::Vector3d impulse = h * force.force_w;
  AddAt(node, (1 - u) * (1 - v) * impulse);
  AddAt({node.i + 1, node.j}, u * (1 - v) * impulse);
  AddAt({node.i, node.j + 1}, (1 - u) * v * impulse);
  AddAt({node.i + 1, node.j + 1}, u * v * impulse);
}

void LoadGatherer::AddAt(GridNode node, const Eigen::Vector3d& impulse_w) {
  Tile& tile = impulses_.Touch(TileOf(node), [] {
    auto empty = std::make_unique<Tile>();
    empty->fill(Eigen::Vector3d::Zero());
    return empty;
  });
  tile[PlaceInTile(node)] += impulse_w;
}

}  // namespace softsoil
