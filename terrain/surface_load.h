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
// Of the sources 0 to sources - 1. Throws InputError, also if a force [N] exceeds `most`.
SurfaceLoad ReadSurfaceLoad(StateReader& reader, int sources, double most);

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
    for (const auto& [node, impulse_w] : InOrder()) {
      if (impulse_w.isZero(0)) continue;
      load->push_back(
          {node, node.i * spacing_, node.j * spacing_, height(node), impulse_w / period, source});
    }
  }
  // Starts anew.
  void Clear() {
    impulses_.clear();
    places_.map.Clear();
  }

  std::size_t MemoryBytes() const { return impulses_.size() * sizeof(Impulse); }
  void Write(StateWriter& writer) const;
  // Throws InputError, also if an impulse [N s] at a node exceeds `most`.
  void Read(StateReader& reader, double most);

 private:
  struct Impulse {
    GridNode node;
    Eigen::Vector3d impulse_w;  // [N s]
  };
  // Where in impulses_ a node stands, -1 if it does not. A copy has none: it is made when it is
  // needed, for most copies are never added to.
  struct Places {
    Places() = default;
    Places(const Places&) {}
    Places& operator=(const Places&) {
      map.Clear();
      return *this;
    }
    TileMap<std::array<int, kTileSide * kTileSide>> map;
  };
  // Where a force acts: the least of the four nodes around it, and how far beyond, in cells.
  struct Cell {
    GridNode node;
    double u, v;
  };
  Cell CellOf(const SurfaceForce& force) const;
  std::vector<Impulse> InOrder() const;
  Eigen::Vector3d& At(GridNode node);
  void FindPlaces();
  int& PlaceOf(GridNode node);

  double spacing_;
  std::vector<Impulse> impulses_;  // in the order in which their nodes were touched
  Places places_;
};

}  // namespace softsoil
