// Forces on the surface, gathered on grid nodes over one soil period.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "terrain/tile_map.h"

namespace softsoil {

// Force [N] on the ground at a point [m], world axes.
struct SurfaceForce {
  Eigen::Vector3d point_w, force_w;
};

// Mean force [N] of a soil period at a grid node, at x, y, z [m]. `source` says whose it is: the
// number of the wheel.
struct NodeForce {
  GridNode node;
  double x, y, z;
  Eigen::Vector3d force_w;
  int source;
};

// In a fixed order: by source, then by tile and place in the tile.
using SurfaceLoad = std::vector<NodeForce>;

void Write(const SurfaceLoad& load, StateWriter& writer);
// Of 0 to sources - 1. Throws InputError.
SurfaceLoad ReadSurfaceLoad(StateReader& reader, int sources);

// Impulses of one source. Each force is shared among the four nodes around it such that the sum
// and the moment about the horizontal axes of its vertical part are kept.
class LoadGatherer {
 public:
  // spacing [m] of the grid.
  explicit LoadGatherer(double spacing) : spacing_(spacing) {}

  // A force that acts for h [s].
  void Add(const SurfaceForce& force, double h);
  // From now on until the object is copied, to add these forces cannot fail for want of memory.
  void Reserve(const std::vector<SurfaceForce>& forces);

  // Appends the mean over `period` [s] to `load`. `height(GridNode)` [m].
  template <class Height>
  void AddMean(int source, double period, const Height& height, SurfaceLoad* load) const {
    impulses_.ForEach([&](TileIndex index, const Tile& tile) {
      for (int place = 0; place < kTileSide * kTileSide; ++place) {
        if (tile[place].isZero(0)) continue;
        const GridNode node = NodeAt(index, place);
        load->push_back({node, node.i * spacing_, node.j * spacing_, height(node),
                         tile[place] / period, source});
      }
    });
  }
  // Starts anew.
  void Clear() { impulses_.Clear(); }

  std::size_t BytesCopied() const { return impulses_.copied() * sizeof(Tile); }
  void Write(StateWriter& writer) const;
  void Read(StateReader& reader);  // throws InputError

 private:
  using Tile = std::array<Eigen::Vector3d, kTileSide * kTileSide>;  // [N s]
  static Tile NoImpulse();
  // Where a force acts: the least of the four nodes around it, and how far beyond, in cells.
  struct Place {
    GridNode node;
    double u, v;
  };
  Place PlaceOf(const SurfaceForce& force) const;
  void AddAt(GridNode node, const Eigen::Vector3d& impulse_w);

  double spacing_;
  TileMap<Tile> impulses_;
};

}  // namespace softsoil
