// The soil below the surface: a column of volumes at every grid node, in tiles made when a load
// first reaches them. Untouched ground costs nothing.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "terrain/column_profiles.h"
#include "terrain/stress_field.h"
#include "terrain/surface.h"
#include "terrain/wall_times.h"

namespace softsoil {

// What one soil period did.
struct PeriodResult {
  std::vector<NodeSinkage> compaction;  // of every column visited, by tile
  std::vector<double> energy;           // [J]  compaction energy by source of the load
  bool lowest_volume_yields = false;    // the column is too short for this load
  // Where the stress came from; none where no column was visited. It has no part in the state.
  std::optional<StressBackend> stress_backend;
};

void Write(const PeriodResult& result, StateWriter& writer);
PeriodResult ReadPeriodResult(StateReader& reader);  // throws InputError

// Copies share what has not changed since.
class Columns {
 public:
  Columns() = default;  // below no ground; to be assigned to
  // The stress field has the concentration factors of the soils.
  Columns(const SoilMap& soils, const ColumnSettings& settings, UndisturbedHeight undisturbed,
          std::unique_ptr<StressField> stress_field);

  // Holds the load on the ground for `period` [s]: stress -> density -> heights.
  //
  // Only those columns are visited that the load can compact, and those with an open load cycle;
  // for all others the result would be the same. If memory runs out, or the stress field throws,
  // all columns stay as they were.
  PeriodResult Advance(const SurfaceLoad& load, double period, WallTimes* times = nullptr);

  std::size_t column_count() const { return tiles_.size() * kColumnsPerTile; }
  std::size_t volume_count() const { return column_count() * settings().volumes; }
  std::size_t MemoryBytes() const;
  std::size_t VolumeBytes() const;  // part of it that grows with the number of volumes

  std::size_t BytesCopied() const;  // that had to be copied, being shared, so far

  void Write(StateWriter& writer) const;
  void Read(StateReader& reader);  // throws InputError

  // Densities [kg/m^3] of the column at a node from the top down; empty if untouched.
  std::vector<double> Densities(GridNode node) const;

 private:
  static constexpr int kColumnsPerTile = kTileSide * kTileSide;
  // What never changes.
  struct Model {
    ColumnProfiles profiles;
    UndisturbedHeight undisturbed;
    std::unique_ptr<StressField> stress_field;
  };
  // 20 bytes per volume: density in double, for it creeps in small steps; the rest in float.
  // Volume k of the column at `place` has the index place * volumes + k, k from the top down.
  struct Tile {
    std::array<double, kColumnsPerTile> base;  // [m]  height of the bottom of the column
    std::vector<double> density;
    std::vector<float> preconsolidation_density, preconsolidation_stress, peak_density;

    SoilVolume Load(std::size_t k) const;
    void Store(std::size_t k, const SoilVolume& volume);
    // Whether any volume of a column is within a load cycle.
    bool IsOpen(int place, int volumes) const;
  };
  struct Visit {
    TileIndex tile;
    int place;
    int soil;
    int source;  // whose load presses most on the column; -1 where none reaches
  };

  const ColumnSettings& settings() const { return model_->profiles.settings(); }
  std::vector<Visit> ColumnsToVisit(const SurfaceLoad& load) const;
  ColumnBatch Geometry(const std::vector<Visit>& visits, const SurfaceLoad& load) const;
  // By visit the tile to write to; null where the column stays as it is, so that its tile may stay
  // shared.
  std::vector<Tile*> TilesToWrite(const std::vector<Visit>& visits,
                                  const std::vector<float>& stress);
  // Returns the compaction energy [J].
  double Compact(Tile& tile, const Visit& visit, const float* stress, double period) const;
  double Sinkage(const Tile& tile, const Visit& visit) const;
  Tile MakeTile(TileIndex index) const;
  Tile& Touch(TileIndex index);
  // Whether a tile could be that of a simulation.
  static bool IsSound(const Tile& tile, std::size_t volumes);

  std::shared_ptr<const Model> model_;
  TileMap<Tile> tiles_;
  std::vector<TileIndex> open_tiles_;  // tiles with an open load cycle, in order
};

}  // namespace softsoil
