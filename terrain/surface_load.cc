#include "terrain/surface_load.h"

#include <algorithm>
#include <cmath>

namespace softsoil {

void LoadGatherer::Add(const SurfaceForce& force, double h) {
  const double gx = force.point_w.x() / spacing_, gy = force.point_w.y() / spacing_;
  const double i = std::floor(gx), j = std::floor(gy);
  const double u = gx - i, v = gy - j;
  const GridNode node{static_cast<int>(i), static_cast<int>(j)};
  const Eigen::Vector3d impulse = h * force.force_w;
  At(node) += (1 - u) * (1 - v) * impulse;
  At({node.i + 1, node.j}) += u * (1 - v) * impulse;
  At({node.i, node.j + 1}) += (1 - u) * v * impulse;
  At({node.i + 1, node.j + 1}) += u * v * impulse;
}

Eigen::Vector3d& LoadGatherer::At(GridNode node) {
  if (places_.map.size() == 0) {
    for (std::size_t k = 0; k < impulses_.size(); ++k)
      PlaceOf(impulses_[k].node) = static_cast<int>(k);
  }
  int& place = PlaceOf(node);
  if (place < 0) {
    impulses_.push_back({node, Eigen::Vector3d::Zero()});
    place = static_cast<int>(impulses_.size()) - 1;
  }
  return impulses_[place].impulse_w;
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
