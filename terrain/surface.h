// The surface of the ground as wheels meet it: heights on a square grid, bilinear in between.
#pragma once

#include <algorithm>
#include <array>
#include <functional>
#include <memory>
#include <vector>

#include "terrain/tile_map.h"

namespace softsoil {

// How far [m] from the origin the ground reaches along x and y: grid indices stay far from
// overflow.
constexpr double kFarthest = 1e6;

// Height [m] of the ground before any wheel came, at x, y [m].
using UndisturbedHeight = std::function<double(double x, double y)>;

// How the surface sinks.
//   kCompaction  by the compaction of the soil below alone, as in the thesis.
//   kFlow        also by bearing sinkage, which is permanent. What exceeds compaction is displaced
//                soil: it moves elsewhere, its volume kept.
enum class SurfaceMode { kCompaction, kFlow };

// Sinkage [m] at a grid node, positive down.
struct NodeSinkage {
  GridNode node;
  double sinkage;
};

// Soil at a grid node, as the thickness [m] of a layer on its cell.
struct NodeSoil {
  GridNode node;
  double thickness;
};

// What the soil at a grid node is made of.
struct NodeLayers {
  double firm;       // [m]  height of the soil that has only sunk
  double moved;      // [m]  loose soil on it that came from elsewhere; below 0: what has slid off
  bool was_pressed;  // by a wheel, deeper than compaction alone
};

// The surface at a point.
struct SurfacePoint {
  double height;                        // [m]
  double sinkage;                       // [m]  below the undisturbed ground; below 0 on a berm
  double loose;                         // [m]  thickness of moved soil on top, which bears nothing
  double slip_sinkage;                  // [m]  by which the soil bears deeper than undisturbed
  double slope_x, slope_y;              // [-]  dz/dx and dz/dy of the surface
  double undisturbed_x, undisturbed_y;  // [-]  the same of the undisturbed ground
};

// A rectangle of the surface copied out for one wheel: quick to look up, independent of tiles.
class SurfacePatch {
 public:
  // Bilinear (3.2). x, y must lie inside the patch: Covers() tells.
  SurfacePoint At(double x, double y) const;
  double HeightAt(double x, double y) const;  // [m]  the same height
  bool Covers(double x, double y) const;

  double spacing() const { return spacing_; }
  GridNode first() const { return first_; }  // corner with the least i and j
  int nodes_x() const { return nodes_x_; }
  int nodes_y() const { return nodes_y_; }
  double Height(int a, int b) const { return height_[a * nodes_y_ + b]; }  // [m] at first + (a, b)
  double Sinkage(int a, int b) const { return sinkage_[a * nodes_y_ + b]; }   // [m]
  double Loose(int a, int b) const { return loose_[a * nodes_y_ + b]; }       // [m]
  double SlipSinkage(int a, int b) const { return slip_[a * nodes_y_ + b]; }  // [m]
  double highest() const { return highest_; }                                 // [m]

 private:
  friend class Surface;
  // A cell: place of its least node, and how far beyond, in cells.
  struct Place {
    std::size_t k;
    double u, v;
  };
  Place PlaceOf(double x, double y) const;

  double spacing_ = 1;
  GridNode first_{0, 0};
  int nodes_x_ = 0, nodes_y_ = 0;
  double highest_ = 0;
  std::vector<double> height_, sinkage_, loose_, slip_;
};

// Copies share what has not changed since.
class Surface {
 public:
  // spacing [m] of the grid, > 0.
  Surface(double spacing, SurfaceMode mode, UndisturbedHeight undisturbed);

  double spacing() const { return spacing_; }
  double NodeHeight(GridNode node) const;   // [m]
  double Height(double x, double y) const;  // [m]  bilinear
  double Undisturbed(GridNode node) const;  // [m]
  NodeLayers Layers(GridNode node) const;
  // The same with another compaction, and by how much [m] the displaced thickness grows with it.
  NodeLayers LayersWith(NodeSinkage compaction) const;
  double DisplacedBy(NodeSinkage compaction) const;

  // Copies the nodes that surround the rectangle [m] into `patch`.
  void CopyPatch(double x_min, double x_max, double y_min, double y_max, SurfacePatch* patch) const;

  // The displaced thickness at a node is max(plastic - compaction, 0) [m]. Its sum over all nodes
  // is that of moved soil, if what is displaced and pushed aside is moved in the end.
  //
  // Compaction of the column below a node, from the soil update.
  void SetCompaction(NodeSinkage compaction);
  // Presses the surface at a node down to a depth below the undisturbed ground; never up. Loose
  // soil gives way first. Returns the thickness [m] pushed aside. Ignored in kCompaction.
  double DeepenPlastic(NodeSinkage depth);
  // Shear weakens the soil below a node: from now on it bears so much [m] deeper. Ignored in
  // kCompaction.
  void AddSlipSinkage(NodeSinkage slip);
  // Loose soil at a node, in place of what was there.
  void SetMoved(NodeSoil moved);
  // From now on until the surface is copied, to set these cannot fail for want of memory.
  void ReserveCompaction(const std::vector<NodeSinkage>& compaction);
  void ReservePlastic(const std::vector<NodeSinkage>& depths);
  void ReserveSlipSinkage(GridNode node);
  void ReserveMoved(const std::vector<NodeSoil>& moved);

  double RutVolume() const;         // [m^3]  below the undisturbed ground
  double BermVolume() const;        // [m^3]  above it
  double CompactionVolume() const;  // [m^3]  lost, the soil being denser
  double DisplacedVolume() const;   // [m^3]  pressed away by wheels beyond compaction
  double MovedVolume() const;  // [m^3]  the same where it has come to lie, but for soil in hand
  std::size_t MemoryBytes() const;

  std::size_t BytesCopied() const;  // that had to be copied, being shared, so far

  // visit(GridNode, double height, double sinkage) for every node of every touched tile.
  void ForEachNode(const std::function<void(GridNode, double, double)>& visit) const;

  void Write(StateWriter& writer) const;
  void Read(StateReader& reader);  // throws InputError

 private:
  using Heights = std::array<double, kTileSide * kTileSide>;  // [m]
  // Each part is shared by itself: a step writes to few.
  struct Tile {
    Cow<Heights> undisturbed, compaction, plastic, moved, slip;

    double Sunk(int place) const { return std::max((*compaction)[place], (*plastic)[place]); }
    double Displaced(int place) const { return Sunk(place) - (*compaction)[place]; }
    double Sinkage(int place) const { return Sunk(place) - (*moved)[place]; }
  };
  Tile MakeTile(TileIndex index) const;
  // Whether a node does not read so already.
  bool Compacts(NodeSinkage compaction) const;
  bool Deepens(const Tile* tile, NodeSinkage depth) const;
  bool Moves(NodeSoil moved) const;
  // Where a node is written to.
  double& Touch(Cow<Heights> Tile::*part, GridNode node);
  // Volume [m^3] of thickness(tile, place) [m] at every node.
  template <class Thickness>
  double Volume(const Thickness& thickness) const;

  double spacing_;
  SurfaceMode mode_;
  std::shared_ptr<const UndisturbedHeight> undisturbed_;
  TileMap<Tile> tiles_;
  std::size_t heights_copied_ = 0;
};

}  // namespace softsoil
