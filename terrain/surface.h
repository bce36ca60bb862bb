// The surface of the ground as wheels meet it: heights on a square grid, bilinear in between.
#pragma once

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
//   kFlow        also by bearing sinkage, which is permanent; what exceeds compaction is
//                displaced soil.
enum class SurfaceMode { kCompaction, kFlow };

// Sinkage [m] at a grid node, positive down.
struct NodeSinkage {
  GridNode node;
  double sinkage;
};

// The surface at a point.
struct SurfacePoint {
  double height;                        // [m]
  double sinkage;                       // [m]  below the undisturbed ground
  double slope_x, slope_y;              // [-]  dz/dx and dz/dy of the surface
  double undisturbed_x, undisturbed_y;  // [-]  the same of the undisturbed ground
};

// A rectangle of the surface copied out for one wheel: quick to look up, independent of tiles.
class SurfacePatch {
 public:
  // Bilinear (3.2). x, y must lie inside the patch: Covers() tells.
  SurfacePoint At(double x, double y) const;
  bool Covers(double x, double y) const;

  double spacing() const { return spacing_; }
  GridNode first() const { return first_; }  // corner with the least i and j
  int nodes_x() const { return nodes_x_; }
  int nodes_y() const { return nodes_y_; }
  double Height(int a, int b) const { return height_[a * nodes_y_ + b]; }  // [m] at first + (a, b)
  double Sinkage(int a, int b) const { return sinkage_[a * nodes_y_ + b]; }  // [m]
  double highest() const { return highest_; }                                // [m]

 private:
  friend class Surface;
  double spacing_ = 1;
  GridNode first_{0, 0};
  int nodes_x_ = 0, nodes_y_ = 0;
  double highest_ = 0;
  std::vector<double> height_, sinkage_;
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

  // Copies the nodes that surround the rectangle [m] into `patch`.
  void CopyPatch(double x_min, double x_max, double y_min, double y_max, SurfacePatch* patch) const;

  // Compaction of the column below a node, from the soil update.
  void SetCompaction(NodeSinkage compaction);
  // Bearing sinkage reached at a node. It never becomes less. Ignored in kCompaction.
  void DeepenPlastic(NodeSinkage plastic);
  // From now on until the surface is copied, to set these cannot fail for want of memory.
  void ReserveCompaction(const std::vector<NodeSinkage>& compaction);
  void ReservePlastic(const std::vector<NodeSinkage>& plastic);

  double RutVolume() const;        // [m^3]  between undisturbed and present surface
  double DisplacedVolume() const;  // [m^3]  part of it that is not compaction
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
    Cow<Heights> undisturbed, compaction, plastic;
  };
  Tile MakeTile(TileIndex index) const;
  // Whether a node does not read so already.
  bool Compacts(NodeSinkage compaction) const;
  bool Deepens(NodeSinkage plastic) const;
  // Where a node is written to.
  double& Touch(Cow<Heights> Tile::*part, GridNode node);
  double Sinkage(const Tile& tile, int place) const;

  double spacing_;
  SurfaceMode mode_;
  std::shared_ptr<const UndisturbedHeight> undisturbed_;
  TileMap<Tile> tiles_;
  std::size_t heights_copied_ = 0;
};

}  // namespace softsoil
