#include "terrain/surface.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace softsoil {

namespace {

// Bilinear interpolation (3.2) at the fractions u, v of a cell, and its slopes.
struct Bilinear {
  Bilinear(const double* row0, const double* row1, double u, double v, double dx) {
    const double along_x = row1[0] - row0[0], along_y = row0[1] - row0[0];
    const double twist = row0[0] - row1[0] - row0[1] + row1[1];
    value = row0[0] + u * along_x + v * along_y + u * v * twist;
    slope_x = (along_x + v * twist) / dx;
    slope_y = (along_y + u * twist) / dx;
  }
  double value, slope_x, slope_y;
};

}  // namespace

SurfacePatch::Place SurfacePatch::PlaceOf(double x, double y) const {
  const double gx = x / spacing_ - first_.i, gy = y / spacing_ - first_.j;
  const int a = std::clamp(static_cast<int>(gx), 0, nodes_x_ - 2);
  const int b = std::clamp(static_cast<int>(gy), 0, nodes_y_ - 2);
  return {static_cast<std::size_t>(a) * nodes_y_ + b, gx - a, gy - b};
}

double SurfacePatch::HeightAt(double x, double y) const {
  const auto [k, u, v] = PlaceOf(x, y);
  return Bilinear(&height_[k], &height_[k + nodes_y_], u, v, spacing_).value;
}

SurfacePoint SurfacePatch::At(double x, double y) const {
  const auto [k, u, v] = PlaceOf(x, y);
  const Bilinear height(&height_[k], &height_[k + nodes_y_], u, v, spacing_);
  const Bilinear sinkage(&sinkage_[k], &sinkage_[k + nodes_y_], u, v, spacing_);
  const Bilinear loose(&loose_[k], &loose_[k + nodes_y_], u, v, spacing_);
  const Bilinear slip(&slip_[k], &slip_[k + nodes_y_], u, v, spacing_);
  return {height.value,
          sinkage.value,
          loose.value,
          slip.value,
          height.slope_x,
          height.slope_y,
          height.slope_x + sinkage.slope_x,
          height.slope_y + sinkage.slope_y};
}

bool SurfacePatch::Covers(double x, double y) const {
  const double gx = x / spacing_ - first_.i, gy = y / spacing_ - first_.j;
  return gx >= 0 && gy >= 0 && gx <= nodes_x_ - 1 && gy <= nodes_y_ - 1;
}

Surface::Surface(double spacing, SurfaceMode mode, UndisturbedHeight undisturbed)
    : spacing_(spacing),
      mode_(mode),
      undisturbed_(std::make_shared<UndisturbedHeight>(std::move(undisturbed))) {}

double Surface::Undisturbed(GridNode node) const {
  return (*undisturbed_)(node.i * spacing_, node.j * spacing_);
}

double Surface::NodeHeight(GridNode node) const {
  const Tile* tile = tiles_.Find(TileOf(node));
  if (tile == nullptr) return Undisturbed(node);
  const int place = PlaceInTile(node);
  return (*tile->undisturbed)[place] - tile->Sinkage(place);
}

NodeLayers Surface::Layers(GridNode node) const {
  const Tile* tile = tiles_.Find(TileOf(node));
  return LayersWith({node, tile != nullptr ? (*tile->compaction)[PlaceInTile(node)] : 0});
}

NodeLayers Surface::LayersWith(NodeSinkage compaction) const {
  const Tile* tile = tiles_.Find(TileOf(compaction.node));
  if (tile == nullptr) {
    return {Undisturbed(compaction.node) - std::max(compaction.sinkage, 0.0), 0, false};
  }
  const int place = PlaceInTile(compaction.node);
  const double plastic = (*tile->plastic)[place];
  return {(*tile->undisturbed)[place] - std::max(compaction.sinkage, plastic),
          (*tile->moved)[place], plastic > 0};
}

double Surface::DisplacedBy(NodeSinkage compaction) const {
  const Tile* tile = tiles_.Find(TileOf(compaction.node));
  const int place = PlaceInTile(compaction.node);
  const double plastic = tile != nullptr ? (*tile->plastic)[place] : 0;
  const double present = tile != nullptr ? tile->Displaced(place) : 0;
  return std::max(compaction.sinkage, plastic) - compaction.sinkage - present;
}

double Surface::Height(double x, double y) const {
  SurfacePatch cell;
  CopyPatch(x, x, y, y, &cell);
  return cell.At(x, y).height;
}

void Surface::CopyPatch(double x_min, double x_max, double y_min, double y_max,
                        SurfacePatch* patch) const {
  const auto below = [this](double x) { return static_cast<int>(std::floor(x / spacing_)); };
  patch->spacing_ = spacing_;
  patch->first_ = {below(x_min), below(y_min)};
  patch->nodes_x_ = below(x_max) - patch->first_.i + 2;
  patch->nodes_y_ = below(y_max) - patch->first_.j + 2;
  const std::size_t count = static_cast<std::size_t>(patch->nodes_x_) * patch->nodes_y_;
  patch->height_.resize(count);
  patch->sinkage_.resize(count);
  patch->loose_.resize(count);
  patch->slip_.resize(count);
  std::size_t k = 0;
  for (int a = 0; a < patch->nodes_x_; ++a) {
    const Tile* tile = nullptr;
    for (int b = 0; b < patch->nodes_y_; ++b, ++k) {
      const GridNode node{patch->first_.i + a, patch->first_.j + b};
      if (b == 0 || (node.j & (kTileSide - 1)) == 0) tile = tiles_.Find(TileOf(node));
      const int place = PlaceInTile(node);
      patch->sinkage_[k] = tile != nullptr ? tile->Sinkage(place) : 0.0;
      patch->loose_[k] = tile != nullptr ? std::max((*tile->moved)[place], 0.0) : 0.0;
      patch->slip_[k] = tile != nullptr ? (*tile->slip)[place] : 0.0;
      const double undisturbed = tile != nullptr ? (*tile->undisturbed)[place] : Undisturbed(node);
      patch->height_[k] = undisturbed - patch->sinkage_[k];
    }
  }
  patch->highest_ = *std::max_element(patch->height_.begin(), patch->height_.end());
}

Surface::Tile Surface::MakeTile(TileIndex index) const {
  Heights undisturbed;
  for (int place = 0; place < kTileSide * kTileSide; ++place) {
    undisturbed[place] = Undisturbed(NodeAt(index, place));
  }
  const auto none = [] { return Cow<Heights>::Make(Heights{}); };
  return {Cow<Heights>::Make(undisturbed), none(), none(), none(), none()};
}

double& Surface::Touch(Cow<Heights> Tile::*part, GridNode node) {
  const TileIndex index = TileOf(node);
  Cow<Heights>& heights = tiles_.Touch(index, [&] { return MakeTile(index); }).*part;
  if (heights.IsShared()) ++heights_copied_;
  return heights.Own()[PlaceInTile(node)];
}

bool Surface::Compacts(NodeSinkage compaction) const {
  const Tile* tile = tiles_.Find(TileOf(compaction.node));
  return tile == nullptr || (*tile->compaction)[PlaceInTile(compaction.node)] != compaction.sinkage;
}

bool Surface::Deepens(const Tile* tile, NodeSinkage depth) const {
  const double sinkage = tile == nullptr ? 0 : tile->Sinkage(PlaceInTile(depth.node));
  return mode_ == SurfaceMode::kFlow && sinkage < depth.sinkage;
}

bool Surface::Moves(NodeSoil moved) const {
  const Tile* tile = tiles_.Find(TileOf(moved.node));
  return tile == nullptr || (*tile->moved)[PlaceInTile(moved.node)] != moved.thickness;
}

void Surface::SetCompaction(NodeSinkage compaction) {
  if (Compacts(compaction)) Touch(&Tile::compaction, compaction.node) = compaction.sinkage;
}

double Surface::DeepenPlastic(NodeSinkage depth) {
  const Tile* tile = tiles_.Find(TileOf(depth.node));
  if (!Deepens(tile, depth)) return 0;
  const int place = PlaceInTile(depth.node);
  const double moved = tile == nullptr ? 0 : (*tile->moved)[place];
  const double pushed = depth.sinkage - (tile == nullptr ? 0 : tile->Sinkage(place));
  const double loose = std::min(pushed, std::max(moved, 0.0));
  if (loose > 0) Touch(&Tile::moved, depth.node) = moved - loose;
  if (loose < pushed) Touch(&Tile::plastic, depth.node) = depth.sinkage + std::min(moved, 0.0);
  return pushed;
}

void Surface::AddSlipSinkage(NodeSinkage slip) {
  if (mode_ == SurfaceMode::kFlow) Touch(&Tile::slip, slip.node) += slip.sinkage;
}

void Surface::SetMoved(NodeSoil moved) {
  if (Moves(moved)) Touch(&Tile::moved, moved.node) = moved.thickness;
}

void Surface::ReserveCompaction(const std::vector<NodeSinkage>& compaction) {
  for (const NodeSinkage& c : compaction) {
    if (Compacts(c)) Touch(&Tile::compaction, c.node);
  }
}

void Surface::ReservePlastic(const std::vector<NodeSinkage>& depths) {
  for (const NodeSinkage& depth : depths) {
    const Tile* tile = tiles_.Find(TileOf(depth.node));
    if (!Deepens(tile, depth)) continue;
    const bool has_loose = tile != nullptr && (*tile->moved)[PlaceInTile(depth.node)] > 0;
    Touch(&Tile::plastic, depth.node);
    if (has_loose) Touch(&Tile::moved, depth.node);
  }
}

void Surface::ReserveSlipSinkage(GridNode node) {
  if (mode_ == SurfaceMode::kFlow) Touch(&Tile::slip, node);
}

void Surface::ReserveMoved(const std::vector<NodeSoil>& moved) {
  for (const NodeSoil& m : moved) {
    if (Moves(m)) Touch(&Tile::moved, m.node);
  }
}

template <class Thickness>
double Surface::Volume(const Thickness& thickness) const {
  double sum = 0;
  tiles_.ForEach([&](TileIndex, const Tile& tile) {
    for (int place = 0; place < kTileSide * kTileSide; ++place) sum += thickness(tile, place);
  });
  return sum * spacing_ * spacing_;
}

double Surface::RutVolume() const {
  return Volume([](const Tile& tile, int k) { return std::max(tile.Sinkage(k), 0.0); });
}

double Surface::BermVolume() const {
  return Volume([](const Tile& tile, int k) { return std::max(-tile.Sinkage(k), 0.0); });
}

double Surface::CompactionVolume() const {
  return Volume([](const Tile& tile, int k) { return (*tile.compaction)[k]; });
}

double Surface::DisplacedVolume() const {
  return Volume([](const Tile& tile, int k) { return tile.Displaced(k); });
}

double Surface::MovedVolume() const {
  return Volume([](const Tile& tile, int k) { return (*tile.moved)[k]; });
}

std::size_t Surface::MemoryBytes() const {
  return tiles_.size() * (sizeof(Tile) + 5 * sizeof(Heights));
}

std::size_t Surface::BytesCopied() const {
  return tiles_.copied() * sizeof(Tile) + tiles_.bytes_copied_beside() +
         heights_copied_ * sizeof(Heights);
}

void Surface::ForEachNode(const std::function<void(GridNode, double, double)>& visit) const {
  tiles_.ForEach([&](TileIndex index, const Tile& tile) {
    for (int place = 0; place < kTileSide * kTileSide; ++place) {
      const double sinkage = tile.Sinkage(place);
      visit(NodeAt(index, place), (*tile.undisturbed)[place] - sinkage, sinkage);
    }
  });
}

void Surface::Write(StateWriter& writer) const {
  tiles_.Write(writer, [](StateWriter& to, const Tile& tile) {
    for (const Cow<Heights>* part : {&tile.compaction, &tile.plastic, &tile.moved, &tile.slip}) {
      to.PutBytes((*part)->data(), sizeof(Heights));
    }
  });
}

void Surface::Read(StateReader& reader) {
  tiles_.Read(
      reader, 4 * sizeof(Heights), [this](TileIndex index) { return MakeTile(index); },
      [](StateReader& from, Tile& tile) {
        for (Cow<Heights>* part : {&tile.compaction, &tile.plastic, &tile.moved, &tile.slip}) {
          Heights& heights = part->Own();
          from.GetFinite(heights.data(), heights.size());
          const auto is_near = [](double height) { return std::abs(height) <= kFarthest; };
          from.Require(std::all_of(heights.begin(), heights.end(), is_near), "a height");
        }
      });
}

}  // namespace softsoil
