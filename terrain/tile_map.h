// Sparse storage over the grid: square tiles that are made when first touched, and shared by all
// copies until one of them writes.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>
#include <tuple>
#include <utility>
#include <vector>

#include "terrain/cow.h"
#include "terrain/state_stream.h"

namespace softsoil {

constexpr int kTileSide = 16;  // grid nodes along the side of a tile

// A node of the square grid: x = i dx, y = j dx.
struct GridNode {
  int i, j;
};

struct TileIndex {
  int i, j;
  bool operator<(const TileIndex& other) const { return i != other.i ? i < other.i : j < other.j; }
  bool operator==(const TileIndex& other) const { return i == other.i && j == other.j; }
};

// Tile that a node lies in, and the node's place in it. Shifts and masks round down for negative
// numbers too.
inline TileIndex TileOf(GridNode node) { return {node.i >> 4, node.j >> 4}; }
inline int PlaceInTile(GridNode node) { return (node.i & 15) * kTileSide + (node.j & 15); }
inline GridNode NodeAt(TileIndex tile, int place) {
  return {tile.i * kTileSide + place / kTileSide, tile.j * kTileSide + place % kTileSide};
}
static_assert(kTileSide == 16, "TileOf and PlaceInTile shift by 4 bits");

// Whether the tile map visits one node before another: by block of 16 x 16 tiles, tile and node.
inline bool IsVisitedBefore(GridNode a, GridNode b) {
  const auto order = [](const GridNode& n) {
    return std::make_tuple(n.i >> 8, n.j >> 8, n.i >> 4, n.j >> 4, n.i, n.j);
  };
  return order(a) < order(b);
}

// The same by tile and node alone.
inline bool IsBeforeByTile(GridNode a, GridNode b) {
  const auto order = [](const GridNode& n) {
    return std::make_tuple(n.i >> 4, n.j >> 4, n.i, n.j);
  };
  return order(a) < order(b);
}

// Tiles at most so far from the origin; their nodes still have 32 bits.
constexpr int kFarthestTile = 1 << 26;
inline bool IsOnGrid(TileIndex index) {
  return std::max(std::abs(static_cast<long>(index.i)), std::abs(static_cast<long>(index.j))) <=
         kFarthestTile;
}

// Tiles of any kind by index; always visited in the order of their blocks and in these by index, so
// that sums over all tiles have the same bits whatever the order in which the tiles were made.
//
// A copy costs one pointer. Who writes first copies the list of blocks, the block and the tile that
// it writes to, and nothing else: what a step costs does not grow with the ground covered.
template <class Tile>
class TileMap {
 public:
  // Null where nothing has been touched.
  const Tile* Find(TileIndex index) const {
    const Cow<Tile>* slot = Slot(index);
    return slot != nullptr ? slot->get() : nullptr;
  }

  // The tile to write to, made by `make()` -> Tile if it is not there. It is this map's alone, and
  // stays where it is, until the map is copied: to touch it again cannot fail. If memory runs out,
  // or make() throws, no tile has changed.
  template <class Make>
  Tile& Touch(TileIndex index, const Make& make) {
    Cow<Tile>& tile = OwnBlock(BlockOf(index))[PlaceInBlock(index)];
    if (!tile) {
      tile = Cow<Tile>::Make(make());
      ++size_;
    } else if (tile.IsShared()) {
      ++copied_;
    }
    return tile.Own();
  }

  // visit(TileIndex, const Tile&)
  template <class Visit>
  void ForEach(const Visit& visit) const {
    if (!blocks_) return;
    for (const auto& [at, block] : *blocks_) {
      for (int place = 0; place < kTilesPerBlock; ++place) {
        const Cow<Tile>& tile = (*block)[place];
        const TileIndex index = {at.i * kBlockSide + place / kBlockSide,
                                 at.j * kBlockSide + place % kBlockSide};
        if (tile) visit(index, *tile);
      }
    }
  }

  std::size_t size() const { return size_; }
  void Clear() {
    blocks_ = {};
    size_ = 0;
  }

  // What had to be copied since the map was made, because it was shared: tiles, and bytes beside.
  std::size_t copied() const { return copied_; }
  std::size_t bytes_copied_beside() const { return bytes_copied_beside_; }

  // write_tile(writer, const Tile&)
  template <class WriteTile>
  void Write(StateWriter& writer, const WriteTile& write_tile) const {
    writer.Put(static_cast<std::uint64_t>(size_));
    ForEach([&](TileIndex index, const Tile& tile) {
      writer.Put(index);
      write_tile(writer, tile);
    });
  }

  // As written, in place of what is there. make(TileIndex) -> Tile; read_tile(reader, Tile&).
  // `bytes` is the least that a tile takes. Throws InputError.
  template <class Make, class ReadTile>
  void Read(StateReader& reader, std::size_t bytes, const Make& make, const ReadTile& read_tile) {
    Clear();
    for (std::uint64_t left = reader.Count(sizeof(TileIndex) + bytes); left > 0; --left) {
      const auto index = reader.Get<TileIndex>();
      reader.Require(IsOnGrid(index) && !Find(index), "an index of a tile");
      read_tile(reader, Touch(index, [&] { return make(index); }));
    }
  }

 private:
  static constexpr int kBlockSide = 16;  // tiles
  static constexpr int kTilesPerBlock = kBlockSide * kBlockSide;
  using Block = std::array<Cow<Tile>, kTilesPerBlock>;
  using Blocks = std::vector<std::pair<TileIndex, Cow<Block>>>;  // by index

  static TileIndex BlockOf(TileIndex index) { return {index.i >> 4, index.j >> 4}; }
  static int PlaceInBlock(TileIndex index) { return (index.i & 15) * kBlockSide + (index.j & 15); }
  static_assert(kBlockSide == 16, "BlockOf and PlaceInBlock shift by 4 bits");

  const Cow<Tile>* Slot(TileIndex index) const {
    if (!blocks_) return nullptr;
    const TileIndex at = BlockOf(index);
    const auto block = PlaceOf(at, *blocks_);
    if (block == blocks_->end() || !(block->first == at)) return nullptr;
    return &(*block->second)[PlaceInBlock(index)];
  }

  Block& OwnBlock(TileIndex at) {
    if (!blocks_) blocks_ = Cow<Blocks>::Make();
    if (blocks_.IsShared()) bytes_copied_beside_ += blocks_->size() * sizeof(blocks_->front());
    Blocks& blocks = blocks_.Own();
    auto block = PlaceOf(at, blocks);
    if (block == blocks.end() || !(block->first == at)) {
      block = blocks.insert(block, {at, Cow<Block>::Make()});
    }
    if (block->second.IsShared()) bytes_copied_beside_ += sizeof(Block);
    return block->second.Own();
  }

  // Where a block stands, or would.
  template <class SomeBlocks>
  static auto PlaceOf(TileIndex at, SomeBlocks& blocks) {
    return std::lower_bound(blocks.begin(), blocks.end(), at,
                            [](const auto& block, TileIndex other) { return block.first < other; });
  }

  Cow<Blocks> blocks_;
  std::size_t size_ = 0, copied_ = 0, bytes_copied_beside_ = 0;
};

}  // namespace softsoil
