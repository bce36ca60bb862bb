#include "terrain/surface_load.h"

#include <algorithm>
#include <cmath>

#include "terrain/surface.h"

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

SurfaceLoad ReadSurfaceLoad(StateReader& reader, int sources, double most) {
  constexpr std::size_t kBytes = sizeof(GridNode) + 6 * sizeof(double) + sizeof(int);
  SurfaceLoad load(reader.Count(kBytes));
  for (NodeForce& f : load) {
    f.node = reader.Get<GridNode>();
    for (double* value : {&f.x, &f.y, &f.z}) *value = reader.GetFinite();
    reader.GetFinite(f.force_w.data(), 3);
    f.source = reader.Get<int>();
    reader.Require(IsOnGrid(TileOf(f.node)), "a node of the load");
    reader.Require(Eigen::Vector3d(f.x, f.y, f.z).cwiseAbs().maxCoeff() <= kFarthest,
                   "the place of a load");
    reader.Require(f.force_w.cwiseAbs().maxCoeff() <= most, "a load");
    reader.Require(f.source >= 0 && f.source < sources, "the source of a load");
  }
  return load;
}

LoadGatherer::Cell LoadGatherer::CellOf(const SurfaceForce& force) const {
  const double gx = force.point_w.x() / spacing_, gy = force.point_w.y() / spacing_;
  const double i = std::floor(gx), j = std::floor(gy);
  return {{static_cast<int>(i), static_cast<int>(j)}, gx - i, gy - j};
}

void LoadGatherer::Add(const SurfaceForce& force, double h) {
  const auto [node, u, v] = CellOf(force);
  const Eigen::Vector3d impulse = h * force.force_w;
  At(node) += (1 - u) * (1 - v) * impulse;
  At({node.i + 1, node.j}) += u * (1 - v) * impulse;
  At({node.i, node.j + 1}) += (1 - u) * v * impulse;
  At({node.i + 1, node.j + 1}) += u * v * impulse;
}

void LoadGatherer::Reserve(const std::vector<SurfaceForce>& forces) {
  for (const SurfaceForce& force : forces) {
    const GridNode node = CellOf(force).node;
    for (const int i : {node.i, node.i + 1}) {
      for (const int j : {node.j, node.j + 1}) At({i, j});
    }
  }
}

Eigen::Vector3d& LoadGatherer::At(GridNode node) {
  if (places_.map.size() == 0) FindPlaces();
  int& place = PlaceOf(node);
  if (place < 0) {
    impulses_.push_back({node, Eigen::Vector3d::Zero()});
    place = static_cast<int>(impulses_.size()) - 1;
  }
  return impulses_[place].impulse_w;
}

// All or none: with some alone a node would get a second impulse.
void LoadGatherer::FindPlaces() {
  try {
    for (std::size_t k = 0; k < impulses_.size(); ++k) {
      PlaceOf(impulses_[k].node) = static_cast<int>(k);
    }
  } catch (...) {
    places_.map.Clear();
    throw;
  }
}

int& LoadGatherer::PlaceOf(GridNode node) {
  const auto none = [] {
    std::array<int, kTileSide * kTileSide> places;
    places.fill(-1);
    return places;
  };
  return places_.map.Touch(TileOf(node), none)[PlaceInTile(node)];
}

// By tile and place in the tile, whatever the order in which they came.
std::vector<LoadGatherer::Impulse> LoadGatherer::InOrder() const {
  std::vector<Impulse> impulses = impulses_;
  std::sort(impulses.begin(), impulses.end(),
            [](const Impulse& a, const Impulse& b) { return IsVisitedBefore(a.node, b.node); });
  return impulses;
}

void LoadGatherer::Write(StateWriter& writer) const {
  const std::vector<Impulse> impulses = InOrder();
  writer.Put(static_cast<std::uint64_t>(impulses.size()));
  for (const auto& [node, impulse_w] : impulses) {
    writer.Put(node);
    writer.PutBytes(impulse_w.data(), sizeof impulse_w);
  }
}

void LoadGatherer::Read(StateReader& reader, double most) {
  impulses_.clear();
  places_ = {};
  for (std::uint64_t left = reader.Count(sizeof(Impulse)); left > 0; --left) {
    const auto node = reader.Get<GridNode>();
    const bool is_next = impulses_.empty() || IsVisitedBefore(impulses_.back().node, node);
    reader.Require(is_next && IsOnGrid(TileOf(node)), "a node of the load");
    impulses_.push_back({node, Eigen::Vector3d::Zero()});
    Eigen::Vector3d& impulse_w = impulses_.back().impulse_w;
    reader.GetFinite(impulse_w.data(), 3);
    reader.Require(impulse_w.cwiseAbs().maxCoeff() <= most, "an impulse on the ground");
  }
}

}  // namespace softsoil
