// Forces on the surface, gathered on grid nodes over one soil period.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "terrain/node_table.h"

namespace softsoil {

// Force [N] on the ground at a point [m], world axes; and slip sinkage times the area [m^3] on
// which it came about.
struct SurfaceForce {
  Eigen::Vector3d point_w, force_w;
  double slip_volume = 0;
};

// A value at a point shared among the four grid nodes around it, as in bilinear interpolation:
// its sum and its moment are kept.
class CellShares {
 public:
  // spacing [m] of the grid.
  CellShares(const Eigen::Vector3d& point_w, double spacing);
  // visit(GridNode, double share)
  template <class Visit>
  void ForEach(const Visit& visit) const {
    visit(node_, (1 - u_) * (1 - v_));
    visit(GridNode{node_.i + 1, node_.j}, u_ * (1 - v_));
    visit(GridNode{node_.i, node_.j + 1}, (1 - u_) * v_);
    visit(GridNode{node_.i + 1, node_.j + 1}, u_ * v_);
  }

 private:
  GridNode node_;  // the least of the four
  double u_, v_;   // how far beyond, in cells
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

// Impulses of one source. Each force is shared among the four nodes around it.
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
    for (const auto& [node, impulse_w] : impulses_.InOrder()) {
      if (impulse_w.isZero(0)) continue;
      load->push_back(
          {node, node.i * spacing_, node.j * spacing_, height(node), impulse_w / period, source});
    }
  }
  // Starts anew.
  void Clear() { impulses_.Clear(); }

  std::size_t MemoryBytes() const { return impulses_.MemoryBytes(); }
  void Write(StateWriter& writer) const;
  // Throws InputError, also if an impulse [N s] at a node exceeds `most`.
  void Read(StateReader& reader, double most);

 private:
  Eigen::Vector3d& At(GridNode node) { return impulses_.At(node, Eigen::Vector3d::Zero()); }

  double spacing_;
  NodeTable<Eigen::Vector3d> impulses_;  // [N s]
};

}  // namespace softsoil
