// Sparse storage over the grid: square tiles that are made when first touched.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <utility>

namespace softsoil {

constexpr int kTileSide = 16;  // grid nodes along the side of a tile

// A node of the square grid: x = i dx, y = j dx.
struct GridNode {
  int i, j;
};

struct TileIndex {
  int i, j;
  bool operator<(const TileIndex& other) const { return i != other.i ? i < other.i : j < other.j; }
};

// Tile that a node lies in, and the node's place in it. Shifts and masks round down for negative
// numbers too.
inline TileIndex TileOf(GridNode node) { return {node.i >> 4, node.j >> 4}; }
inline int PlaceInTile(GridNode node) { return (node.i & 15) * kTileSide + (node.j & 15); }
inline GridNode NodeAt(TileIndex tile, int place) {
  return {tile.i * kTileSide + place / kTileSide, tile.j * kTileSide + place % kTileSide};
}
static_assert(kTileSide == 16, "TileOf and PlaceInTile shift by 4 bits");

// Tiles of any kind by index; always visited in the order of the index, so that sums over all
// tiles have the same bits whatever the order in which the tiles were made.
template <class Tile>
class TileMap {
 public:
  // Null where nothing has been touched.
  const Tile* Find(TileIndex index) const {
    const auto it = tiles_.find(index);
    return it == tiles_.end() ? nullptr : it->second.get();
  }
  Tile* Find(TileIndex index) { return const_cast<Tile*>(std::as_const(*this).Find(index)); }

  // The tile, made by `make()` -> std::unique_ptr<Tile> if it is not there.
  template <class Make>
  Tile& Touch(TileIndex index, const Make& make) {
    auto it = tiles_.lower_bound(index);
    if (it == tiles_.end() || index < it->first) it = tiles_.emplace_hint(it, index, make());
    return *it->second;
  }

  // visit(TileIndex, Tile&)
  template <class Visit>
  void ForEach(const Visit& visit) const {
    for (const auto& [index, tile] : tiles_) visit(index, std::as_const(*tile));
  }

  std::size_t size() const { return tiles_.size(); }
  void Clear() { tiles_.clear(); }

 private:
  std::map<TileIndex, std::unique_ptr<Tile>> tiles_;
};

}  // namespace softsoil
