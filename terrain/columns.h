// The soil below the surface: a column of volumes at every grid node, in tiles made when a load
// first reaches them. Untouched ground costs nothing.
#pragma once

#include <memory>
#include <set>
#include <vector>

#include "terrain/soil.h"
#include "terrain/stress_field.h"
#include "terrain/surface.h"

namespace softsoil {

struct ColumnSettings {
  double spacing;        // [m]  of the grid, > 0
  double volume_height;  // [m]  initial height w of a volume, > 0
  int volumes;           // [-]  per column, > 0
};

// What one soil period did.
struct PeriodResult {
  std::vector<NodeSinkage> compaction;  // of every column visited
  std::vector<double> energy;           // [J]  compaction energy by source of the load
  bool lowest_volume_yields = false;    // the column is too short for this load
};

class Columns {
 public:
  Columns(const Soil& soil, const ColumnSettings& settings, UndisturbedHeight undisturbed,
          std::unique_ptr<StressField> stress_field);
  ~Columns();

  // Holds the load on the ground for `period` [s]: stress -> density -> heights.
  //
  // Only those columns are visited that the load can compact, and those with an open load cycle;
  // for all others the result would be the same.
  PeriodResult Advance(const SurfaceLoad& load, double period);

  std::size_t column_count() const { return tiles_.size() * kColumnsPerTile; }
  std::size_t volume_count() const { return column_count() * settings_.volumes; }
  std::size_t MemoryBytes() const;
  std::size_t VolumeBytes() const;  // part of it that grows with the number of volumes

  // Densities [kg/m^3] of the column at a node from the top down; empty if untouched.
  std::vector<double> Densities(GridNode node) const;

 private:
  static constexpr int kColumnsPerTile = kTileSide * kTileSide;
  struct Tile;
  struct Visit {
    TileIndex tile;
    int place;
    int source;  // whose load presses most on the column; -1 where none reaches
  };

  std::vector<Visit> ColumnsToVisit(const SurfaceLoad& load);
  ColumnBatch Geometry(const std::vector<Visit>& visits, const SurfaceLoad& load) const;
  // Returns the compaction energy [J].
  double Compact(const Visit& visit, const float* stress, double period);
  double Sinkage(const Visit& visit) const;
  // Mass [kg/m^2] of the volume k per area of its column; compaction does not change it.
  double VolumeMass(int k) const {
    return settings_.volume_height * undisturbed_volumes_[k].density;
  }
  Tile& Touch(TileIndex index);

  Soil soil_;
  ColumnSettings settings_;
  UndisturbedHeight undisturbed_;
  std::vector<SoilVolume> undisturbed_volumes_;  // of any column, from the top down
  double yield_stress_;                          // [Pa]  of the weakest of them
  std::unique_ptr<StressField> stress_field_;
  TileMap<Tile> tiles_;
  std::set<TileIndex> open_tiles_;  // tiles with an open load cycle
};

}  // namespace softsoil
