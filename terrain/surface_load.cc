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
  impulses_.Touch(TileOf(node), NoImpulse)[PlaceInTile(node)] += impulse_w;
}

LoadGatherer::Tile LoadGatherer::NoImpulse() {
  Tile tile;
  tile.fill(Eigen::Vector3d::Zero());
  return tile;
}

void LoadGatherer::Write(StateWriter& writer) const {
  impulses_.Write(writer,
                  [](StateWriter& to, const Tile& tile) { to.PutBytes(tile.data(), sizeof tile); });
}

void LoadGatherer::Read(StateReader& reader, double most) {
  impulses_.Read(
      reader, sizeof(Tile), [](TileIndex) { return NoImpulse(); },
      [most](StateReader& from, Tile& tile) {
        from.GetFinite(tile.front().data(), 3 * tile.size());
        for (const Eigen::Vector3d& impulse : tile) {
          from.Require(impulse.cwiseAbs().maxCoeff() <= most, "an impulse on the ground");
        }
      });
}

}  // namespace softsoil
