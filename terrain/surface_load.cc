#include "terrain/surface_load.h"

#include <cmath>
#include <optional>

namespace softsoil {

void Write(const SurfaceLoad& load, StateWriter& writer) {
  writer.Put(static_cast<std::uint64_t>(load.size()));
  for (const NodeForce& f : load) {
    writer.Put(f.node);
    for (const double value : {f.x, f.y, f.z}) writer.Put(value);
    writer.PutBytes(f.force_w.data(), sizeof f.force_w);
    writer.Put(f.source);
  }
}

SurfaceLoad ReadSurfaceLoad(StateReader& reader, int sources) {
  constexpr std::size_t kBytes = sizeof(GridNode) + 6 * sizeof(double) + sizeof(int);
  SurfaceLoad load(reader.Count(kBytes));
  for (NodeForce& f : load) {
    f.node = reader.Get<GridNode>();
    for (double* value : {&f.x, &f.y, &f.z}) *value = reader.GetFinite();
    reader.GetFinite(f.force_w.data(), 3);
    f.source = reader.Get<int>();
    reader.Require(f.source >= 0 && f.source < sources, "the source of a load");
  }
  return load;
}

LoadGatherer::Place LoadGatherer::PlaceOf(const SurfaceForce& force) const {
  const double gx = force.point_w.x() / spacing_, gy = force.point_w.y() / spacing_;
  const double i = std::floor(gx), j = std::floor(gy);
  return {{static_cast<int>(i), static_cast<int>(j)}, gx - i, gy - j};
}

void LoadGatherer::Add(const SurfaceForce& force, double h) {
  const auto [node, u, v] = PlaceOf(force);
  const Eigen::Vector3d impulse = h * force.force_w;
  AddAt(node, (1 - u) * (1 - v) * impulse);
  AddAt({node.i + 1, node.j}, u * (1 - v) * impulse);
  AddAt({node.i, node.j + 1}, (1 - u) * v * impulse);
  AddAt({node.i + 1, node.j + 1}, u * v * impulse);
}

void LoadGatherer::Reserve(const std::vector<SurfaceForce>& forces) {
  std::optional<TileIndex> reserved;  // most nodes are in the tile of the one before
  for (const SurfaceForce& force : forces) {
    const auto [i, j] = PlaceOf(force).node;
    const TileIndex first = TileOf({i, j}), last = TileOf({i + 1, j + 1});
    if (reserved && first == *reserved && last == *reserved) continue;
    for (const int a : {first.i, last.i}) {
      for (const int b : {first.j, last.j}) impulses_.Touch({a, b}, NoImpulse);
    }
    reserved = last;
  }
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

void LoadGatherer::Read(StateReader& reader) {
  impulses_.Read(
      reader, sizeof(Tile), [](TileIndex) { return NoImpulse(); },
      [](StateReader& from, Tile& tile) { from.GetFinite(tile.front().data(), 3 * tile.size()); });
}

}  // namespace softsoil
