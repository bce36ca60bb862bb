#include "terrain/columns.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "terrain/load_reach.h"

namespace softsoil {

// 20 bytes per volume: density in double, for it creeps in small steps; the rest in float.
// Volume k of the column at `place` has the index place * volumes + k, k from the top down.
struct Columns::Tile {
  std::array<double, kColumnsPerTile> base;  // [m]  height of the bottom of the column
  std::vector<double> density;
  std::vector<float> preconsolidation_density, preconsolidation_stress, peak_density;

  void Resize(std::size_t count) {
    density.resize(count);
    preconsolidation_density.resize(count);
    preconsolidation_stress.resize(count);
    peak_density.resize(count);
  }
  SoilVolume Load(std::size_t k) const {
    return {density[k], preconsolidation_density[k], preconsolidation_stress[k], peak_density[k],
            preconsolidation_density[k]};
  }
  // Whether any volume of a column is within a load cycle.
  bool IsOpen(int place, int volumes) const {
    const float* peak = &peak_density[std::size_t(place) * volumes];
    return std::any_of(peak, peak + volumes, [](float p) { return p > 0; });
  }
  void Store(std::size_t k, const SoilVolume& volume) {
    density[k] = volume.density;
    preconsolidation_density[k] = static_cast<float>(volume.preconsolidation_density);
    preconsolidation_stress[k] = static_cast<float>(volume.preconsolidation_stress);
    peak_density[k] = static_cast<float>(volume.peak_density);
  }
};

Columns::Columns(const Soil& soil, const ColumnSettings& settings, UndisturbedHeight undisturbed,
                 std::unique_ptr<StressField> stress_field)
    : soil_(soil),
      settings_(settings),
      undisturbed_(std::move(undisturbed)),
      stress_field_(std::move(stress_field)) {
  for (int k = 0; k < settings.volumes; ++k) {
    const double middle = (k + 0.5) * settings.volume_height;
    const SoilVolume volume = UndisturbedVolume(soil.compaction, InitialDensity(soil, middle));
    undisturbed_volumes_.push_back(volume);
    yield_stress_ = k == 0 ? volume.preconsolidation_stress
                           : std::min(yield_stress_, volume.preconsolidation_stress);
  }
}

Columns::~Columns() = default;

PeriodResult Columns::Advance(const SurfaceLoad& load, double period) {
  const std::vector<Visit> visits = ColumnsToVisit(load);
  std::vector<float> stress;
  stress_field_->VerticalStress(Geometry(visits, load), load, &stress);

  PeriodResult result;
  open_tiles_.clear();
  for (std::size_t i = 0; i < visits.size(); ++i) {
    const Visit& visit = visits[i];
    const double energy = Compact(visit, &stress[i * settings_.volumes], period);
    if (visit.source >= static_cast<int>(result.energy.size())) {
      result.energy.resize(visit.source + 1);
    }
    if (visit.source >= 0) result.energy[visit.source] += energy;
    result.compaction.push_back({NodeAt(visit.tile, visit.place), Sinkage(visit)});
    const Tile& tile = *tiles_.Find(visit.tile);
    if (!tile.IsOpen(visit.place, settings_.volumes)) continue;
    open_tiles_.insert(visit.tile);
    const std::size_t lowest = std::size_t(visit.place + 1) * settings_.volumes - 1;
    if (tile.peak_density[lowest] > 0) result.lowest_volume_yields = true;
  }
  return result;
}

std::vector<Columns::Visit> Columns::ColumnsToVisit(const SurfaceLoad& load) {
  const LoadReach reach(load, soil_.concentration_factor);
  const double dx = settings_.spacing;
  std::vector<Visit> visits;
  reach.ForEachRectangle(yield_stress_, [&](double x0, double x1, double y0, double y1) {
    for (int i = static_cast<int>(std::ceil(x0 / dx)); i * dx <= x1; ++i) {
      for (int j = static_cast<int>(std::ceil(y0 / dx)); j * dx <= y1; ++j) {
        const LoadReach::Bound bound = reach.At(i * dx, j * dx);
        if (bound.stress < yield_stress_) continue;
        visits.push_back({TileOf({i, j}), PlaceInTile({i, j}), bound.source});
      }
    }
  });
  for (const TileIndex& index : open_tiles_) {
    const Tile& tile = *tiles_.Find(index);
    for (int place = 0; place < kColumnsPerTile; ++place) {
      if (!tile.IsOpen(place, settings_.volumes)) continue;
      const GridNode node = NodeAt(index, place);
      visits.push_back({index, place, reach.At(node.i * dx, node.j * dx).source});
    }
  }
  const auto before = [](const Visit& a, const Visit& b) {
    return a.tile < b.tile || (!(b.tile < a.tile) && a.place < b.place);
  };
  std::sort(visits.begin(), visits.end(), before);
  const auto same = [&](const Visit& a, const Visit& b) { return !before(a, b) && !before(b, a); };
  visits.erase(std::unique(visits.begin(), visits.end(), same), visits.end());
  for (const Visit& visit : visits) Touch(visit.tile);
  return visits;
}

ColumnBatch Columns::Geometry(const std::vector<Visit>& visits, const SurfaceLoad& load) const {
  std::map<std::pair<int, int>, double> pressure;
  const double area = settings_.spacing * settings_.spacing;
  for (const NodeForce& f : load) pressure[{f.node.i, f.node.j}] -= f.force_w.z() / area;

  ColumnBatch batch;
  batch.volumes = settings_.volumes;
  batch.z.resize(visits.size() * settings_.volumes);
  for (std::size_t i = 0; i < visits.size(); ++i) {
    const GridNode node = NodeAt(visits[i].tile, visits[i].place);
    batch.x.push_back(node.i * settings_.spacing);
    batch.y.push_back(node.j * settings_.spacing);
    const auto own = pressure.find({node.i, node.j});
    batch.surface_pressure.push_back(own != pressure.end() ? own->second : 0.0);

    const Tile& tile = *tiles_.Find(visits[i].tile);
    double bottom = tile.base[visits[i].place];
    for (int k = settings_.volumes - 1; k >= 0; --k) {
      const double height =
          VolumeMass(k) / tile.density[std::size_t(visits[i].place) * settings_.volumes + k];
      batch.z[i * settings_.volumes + k] = bottom + height / 2;
      bottom += height;
    }
  }
  return batch;
}

double Columns::Compact(const Visit& visit, const float* stress, double period) {
  Tile& tile = *tiles_.Find(visit.tile);
  const double area = settings_.spacing * settings_.spacing;
  double energy = 0;
  for (int k = 0; k < settings_.volumes; ++k) {
    const std::size_t index = std::size_t(visit.place) * settings_.volumes + k;
    SoilVolume volume = tile.Load(index);
    const double before = volume.density;
    softsoil::Advance(soil_.compaction, stress[k], period, volume);
    energy += CompactionEnergy(stress[k], before, volume.density) * area * VolumeMass(k) / before;
    tile.Store(index, volume);
  }
  return energy;
}

double Columns::Sinkage(const Visit& visit) const {
  const Tile& tile = *tiles_.Find(visit.tile);
  double strain = 0;
  for (int k = 0; k < settings_.volumes; ++k) {
    const std::size_t index = std::size_t(visit.place) * settings_.volumes + k;
    strain += 1 - undisturbed_volumes_[k].density / tile.density[index];
  }
  return settings_.volume_height * strain;
}

Columns::Tile& Columns::Touch(TileIndex index) {
  return tiles_.Touch(index, [this, index] {
    auto tile = std::make_unique<Tile>();
    tile->Resize(std::size_t(kColumnsPerTile) * settings_.volumes);
    for (std::size_t k = 0; k < tile->density.size(); ++k) {
      tile->Store(k, undisturbed_volumes_[k % settings_.volumes]);
    }
    const double depth = settings_.volumes * settings_.volume_height;
    for (int place = 0; place < kColumnsPerTile; ++place) {
      const GridNode node = NodeAt(index, place);
      tile->base[place] =
          undisturbed_(node.i * settings_.spacing, node.j * settings_.spacing) - depth;
    }
    return tile;
  });
}

std::size_t Columns::MemoryBytes() const { return tiles_.size() * sizeof(Tile) + VolumeBytes(); }

std::size_t Columns::VolumeBytes() const {
  return volume_count() * (sizeof(double) + 3 * sizeof(float));
}

std::vector<double> Columns::Densities(GridNode node) const {
  const Tile* tile = tiles_.Find(TileOf(node));
  if (tile == nullptr) return {};
  const auto first = tile->density.begin() + PlaceInTile(node) * settings_.volumes;
  return {first, first + settings_.volumes};
}

}  // namespace softsoil
