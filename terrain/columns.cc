#include "terrain/columns.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "terrain/load_reach.h"

namespace softsoil {
namespace {

constexpr std::size_t kVolumeBytes = sizeof(double) + 3 * sizeof(float);

}  // namespace

void Write(const PeriodResult& result, StateWriter& writer) {
  writer.Put(static_cast<std::uint64_t>(result.compaction.size()));
  for (const NodeSinkage& c : result.compaction) {
    writer.Put(c.node);
    writer.Put(c.sinkage);
  }
  writer.PutAll(result.energy);
  writer.Put(result.lowest_volume_yields);
}

PeriodResult ReadPeriodResult(StateReader& reader) {
  PeriodResult result;
  result.compaction.resize(reader.Count(sizeof(GridNode) + sizeof(double)));
  for (std::size_t k = 0; k < result.compaction.size(); ++k) {
    NodeSinkage& c = result.compaction[k];
    c.node = reader.Get<GridNode>();
    const bool is_next = k == 0 || IsBeforeByTile(result.compaction[k - 1].node, c.node);
    reader.Require(is_next && IsOnGrid(TileOf(c.node)), "a node of the ground");
    c.sinkage = reader.GetFinite();
    reader.Require(std::abs(c.sinkage) <= kFarthest, "a compaction");
  }
  result.energy.resize(reader.Count(sizeof(double)));
  reader.GetFinite(result.energy.data(), result.energy.size());
  result.lowest_volume_yields = reader.GetFlag();
  return result;
}

SoilVolume Columns::Tile::Load(std::size_t k) const {
  return {density[k], preconsolidation_density[k], preconsolidation_stress[k], peak_density[k],
          preconsolidation_density[k]};
}

void Columns::Tile::Store(std::size_t k, const SoilVolume& volume) {
  density[k] = volume.density;
  preconsolidation_density[k] = static_cast<float>(volume.preconsolidation_density);
  preconsolidation_stress[k] = static_cast<float>(volume.preconsolidation_stress);
  peak_density[k] = static_cast<float>(volume.peak_density);
}

bool Columns::Tile::IsOpen(int place, int volumes) const {
  const float* peak = &peak_density[std::size_t(place) * volumes];
  return std::any_of(peak, peak + volumes, [](float p) { return p > 0; });
}

Columns::Columns(const SoilMap& soils, const ColumnSettings& settings,
                 UndisturbedHeight undisturbed, std::unique_ptr<StressField> stress_field)
    : model_(std::make_shared<Model>(Model{ColumnProfiles(soils, settings), std::move(undisturbed),
                                           std::move(stress_field)})) {}

PeriodResult Columns::Advance(const SurfaceLoad& load, double period, WallTimes* times) {
  // All that may fail comes first.
  std::vector<Visit> visits;
  std::vector<float> stress;
  ColumnBatch batch;
  {
    const Stopwatch stopwatch(times, Work::kStress);
    visits = ColumnsToVisit(load);
    for (const Visit& visit : visits) {
      if (tiles_.Find(visit.tile) == nullptr) Touch(visit.tile);
    }
    batch = Geometry(visits, load);
    model_->stress_field->VerticalStress(batch, load, &stress);
  }
  const Stopwatch stopwatch(times, Work::kCompaction);
  const std::vector<Tile*> tiles = TilesToWrite(visits, stress);
  PeriodResult result;
  if (!visits.empty()) result.stress_backend = model_->stress_field->BackendFor(batch, load);
  result.compaction.reserve(visits.size());
  for (const Visit& visit : visits) {
    if (visit.source >= static_cast<int>(result.energy.size())) {
      result.energy.resize(visit.source + 1);
    }
  }
  std::vector<TileIndex> open_tiles;
  open_tiles.reserve(visits.size());

  const int volumes = settings().volumes;
  for (std::size_t i = 0; i < visits.size(); ++i) {
    const Visit& visit = visits[i];
    const Tile& tile = *tiles_.Find(visit.tile);
    if (tiles[i] != nullptr) {
      const double energy = Compact(*tiles[i], visit, &stress[i * volumes], period);
      if (visit.source >= 0) result.energy[visit.source] += energy;
    }
    result.compaction.push_back({NodeAt(visit.tile, visit.place), Sinkage(tile, visit)});
    if (tiles[i] == nullptr || !tile.IsOpen(visit.place, volumes)) continue;
    if (open_tiles.empty() || !(open_tiles.back() == visit.tile)) open_tiles.push_back(visit.tile);
    const std::size_t lowest = std::size_t(visit.place + 1) * volumes - 1;
    if (tile.peak_density[lowest] > 0) result.lowest_volume_yields = true;
  }
  open_tiles_ = std::move(open_tiles);
  return result;
}

std::vector<Columns::Visit> Columns::ColumnsToVisit(const SurfaceLoad& load) const {
  const ColumnProfiles& profiles = model_->profiles;
  const LoadReach reach(load, profiles.farthest_reaching_factor());
  const double dx = settings().spacing, least = profiles.least_yield_stress();
  std::vector<Visit> visits;
  reach.ForEachRectangle(least, [&](double x0, double x1, double y0, double y1) {
    for (int i = static_cast<int>(std::ceil(x0 / dx)); i * dx <= x1; ++i) {
      for (int j = static_cast<int>(std::ceil(y0 / dx)); j * dx <= y1; ++j) {
        const LoadReach::Bound bound = reach.At(i * dx, j * dx);
        if (bound.stress < least) continue;
        const int soil = profiles.SoilAt({i, j});
        if (bound.stress < profiles[soil].yield_stress) continue;
        visits.push_back({TileOf({i, j}), PlaceInTile({i, j}), soil, bound.source});
      }
    }
  });
  for (const TileIndex& index : open_tiles_) {
    const Tile& tile = *tiles_.Find(index);
    for (int place = 0; place < kColumnsPerTile; ++place) {
      if (!tile.IsOpen(place, settings().volumes)) continue;
      const GridNode node = NodeAt(index, place);
      const int source = reach.At(node.i * dx, node.j * dx).source;
      visits.push_back({index, place, profiles.SoilAt(node), source});
    }
  }
  const auto before = [](const Visit& a, const Visit& b) {
    return a.tile < b.tile || (!(b.tile < a.tile) && a.place < b.place);
  };
  std::sort(visits.begin(), visits.end(), before);
  const auto same = [&](const Visit& a, const Visit& b) { return !before(a, b) && !before(b, a); };
  visits.erase(std::unique(visits.begin(), visits.end(), same), visits.end());
  return visits;
}

ColumnBatch Columns::Geometry(const std::vector<Visit>& visits, const SurfaceLoad& load) const {
  const double dx = settings().spacing;
  const int volumes = settings().volumes;
  std::map<std::pair<int, int>, double> pressure;
  for (const NodeForce& f : load) pressure[{f.node.i, f.node.j}] -= f.force_w.z() / (dx * dx);

  ColumnBatch batch;
  batch.volumes = volumes;
  batch.z.resize(visits.size() * volumes);
  for (std::size_t i = 0; i < visits.size(); ++i) {
    const GridNode node = NodeAt(visits[i].tile, visits[i].place);
    batch.x.push_back(node.i * dx);
    batch.y.push_back(node.j * dx);
    const auto own = pressure.find({node.i, node.j});
    batch.surface_pressure.push_back(own != pressure.end() ? own->second : 0.0);
    batch.soil.push_back(visits[i].soil);

    const Tile& tile = *tiles_.Find(visits[i].tile);
    double bottom = tile.base[visits[i].place];
    for (int k = volumes - 1; k >= 0; --k) {
      const std::size_t index = std::size_t(visits[i].place) * volumes + k;
      const double height = model_->profiles.VolumeMass(visits[i].soil, k) / tile.density[index];
      batch.z[i * volumes + k] = bottom + height / 2;
      bottom += height;
    }
  }
  return batch;
}

std::vector<Columns::Tile*> Columns::TilesToWrite(const std::vector<Visit>& visits,
                                                  const std::vector<float>& stress) {
  const int volumes = settings().volumes;
  std::vector<Tile*> tiles;
  for (std::size_t i = 0; i < visits.size(); ++i) {
    const Tile& tile = *tiles_.Find(visits[i].tile);
    bool changes = false;
    for (int k = 0; k < volumes && !changes; ++k) {
      const std::size_t index = std::size_t(visits[i].place) * volumes + k;
      changes = CanChange(tile.Load(index), stress[i * volumes + k]);
    }
    tiles.push_back(changes ? &Touch(visits[i].tile) : nullptr);
  }
  return tiles;
}

double Columns::Compact(Tile& tile, const Visit& visit, const float* stress, double period) const {
  const Compaction& soil = model_->profiles.CompactionOf(visit.soil);
  const double area = settings().spacing * settings().spacing;
  double energy = 0;
  for (int k = 0; k < settings().volumes; ++k) {
    const std::size_t index = std::size_t(visit.place) * settings().volumes + k;
    SoilVolume volume = tile.Load(index);
    const double before = volume.density;
    softsoil::Advance(soil, stress[k], period, volume);
    energy += CompactionEnergy(stress[k], before, volume.density) * area *
              model_->profiles.VolumeMass(visit.soil, k) / before;
    tile.Store(index, volume);
  }
  return energy;
}

double Columns::Sinkage(const Tile& tile, const Visit& visit) const {
  const std::vector<SoilVolume>& undisturbed = model_->profiles[visit.soil].volumes;
  double strain = 0;
  for (std::size_t k = 0; k < undisturbed.size(); ++k) {
    strain += 1 - undisturbed[k].density / tile.density[visit.place * undisturbed.size() + k];
  }
  return settings().volume_height * strain;
}

Columns::Tile Columns::MakeTile(TileIndex index) const {
  const ColumnSettings& s = settings();
  const std::size_t count = std::size_t(kColumnsPerTile) * s.volumes;
  Tile tile;
  tile.density.resize(count);
  tile.preconsolidation_density.resize(count);
  tile.preconsolidation_stress.resize(count);
  tile.peak_density.resize(count);
  const double depth = s.volumes * s.volume_height;
  for (int place = 0; place < kColumnsPerTile; ++place) {
    const GridNode node = NodeAt(index, place);
    const ColumnProfile& profile = model_->profiles[model_->profiles.SoilAt(node)];
    for (int k = 0; k < s.volumes; ++k) {
      tile.Store(std::size_t(place) * s.volumes + k, profile.volumes[k]);
    }
    tile.base[place] = model_->undisturbed(node.i * s.spacing, node.j * s.spacing) - depth;
  }
  return tile;
}

Columns::Tile& Columns::Touch(TileIndex index) {
  return tiles_.Touch(index, [&] { return MakeTile(index); });
}

std::size_t Columns::MemoryBytes() const { return tiles_.size() * sizeof(Tile) + VolumeBytes(); }

std::size_t Columns::VolumeBytes() const { return volume_count() * kVolumeBytes; }

std::size_t Columns::BytesCopied() const {
  const std::size_t volumes = std::size_t(kColumnsPerTile) * settings().volumes;
  return tiles_.copied() * (sizeof(Tile) + volumes * kVolumeBytes) + tiles_.bytes_copied_beside();
}

void Columns::Write(StateWriter& writer) const {
  tiles_.Write(writer, [](StateWriter& to, const Tile& tile) {
    to.PutAll(tile.density);
    to.PutAll(tile.preconsolidation_density);
    to.PutAll(tile.preconsolidation_stress);
    to.PutAll(tile.peak_density);
  });
  writer.PutAll(open_tiles_);
}

void Columns::Read(StateReader& reader) {
  const std::size_t volumes = std::size_t(kColumnsPerTile) * settings().volumes;
  const auto read = [&](StateReader& from, Tile& tile) {
    tile.density = from.GetAll<double>();
    for (auto* values :
         {&tile.preconsolidation_density, &tile.preconsolidation_stress, &tile.peak_density}) {
      *values = from.GetAll<float>();
    }
    from.Require(IsSound(tile, volumes), "a soil volume");
  };
  tiles_.Read(
      reader, volumes * kVolumeBytes, [&](TileIndex index) { return MakeTile(index); }, read);
  open_tiles_ = reader.GetAll<TileIndex>();
  for (const TileIndex& index : open_tiles_) {
    reader.Require(tiles_.Find(index) != nullptr, "a tile with an open load cycle");
  }
}

bool Columns::IsSound(const Tile& tile, std::size_t volumes) {
  const auto positive = [](double v) { return v > 0 && std::isfinite(v); };
  const auto at_least_zero = [](double v) { return v >= 0 && std::isfinite(v); };
  const auto all = [volumes](const auto& values, const auto& holds) {
    return values.size() == volumes && std::all_of(values.begin(), values.end(), holds);
  };
  return all(tile.density, positive) && all(tile.preconsolidation_density, positive) &&
         all(tile.preconsolidation_stress, positive) && all(tile.peak_density, at_least_zero);
}

std::vector<double> Columns::Densities(GridNode node) const {
  const Tile* tile = tiles_.Find(TileOf(node));
  if (tile == nullptr) return {};
  const int volumes = settings().volumes;
  const auto first = tile->density.begin() + PlaceInTile(node) * volumes;
  return {first, first + volumes};
}

}  // namespace softsoil
