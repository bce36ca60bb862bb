// Values at a few grid nodes, found by node.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "terrain/tile_map.h"

namespace softsoil {

template <class Value>
class NodeTable {
 public:
  struct Entry {
    GridNode node;
    Value value;
  };

  // Of a node that is not there yet: `zero`. To ask again cannot fail, until the table is copied.
  Value& At(GridNode node, const Value& zero) {
    if (places_.map.size() == 0) FindPlaces();
    int& place = PlaceOf(node);
    if (place < 0) {
      entries_.push_back({node, zero});
      place = static_cast<int>(entries_.size()) - 1;
    }
    return entries_[place].value;
  }

  // By tile and place in the tile, whatever the order in which they came.
  std::vector<Entry> InOrder() const {
    std::vector<Entry> entries = entries_;
    std::sort(entries.begin(), entries.end(),
              [](const Entry& a, const Entry& b) { return IsVisitedBefore(a.node, b.node); });
    return entries;
  }

  void Clear() {
    entries_.clear();
    places_.map.Clear();
  }
  std::size_t MemoryBytes() const { return entries_.size() * sizeof(Entry); }

  // Reads nodes that were written in order. read_value(StateReader&) -> Value. Throws InputError.
  template <class ReadValue>
  void Read(StateReader& reader, std::size_t bytes, const ReadValue& read_value) {
    Clear();
    for (std::uint64_t left = reader.Count(sizeof(GridNode) + bytes); left > 0; --left) {
      const auto node = reader.Get<GridNode>();
      const bool is_next = entries_.empty() || IsVisitedBefore(entries_.back().node, node);
      reader.Require(is_next && IsOnGrid(TileOf(node)), "a grid node");
      entries_.push_back({node, read_value(reader)});
    }
  }

 private:
  // Where in entries_ a node stands, -1 if it does not. A copy has none: it is made when it is
  // needed, for most copies are never added to.
  struct Places {
    Places() = default;
    Places(const Places&) {}
    Places& operator=(const Places&) {
      map.Clear();
      return *this;
    }
    TileMap<std::array<int, kTileSide * kTileSide>> map;
  };
  // All or none: with some alone a node would get a second entry.
  void FindPlaces() {
    try {
      for (std::size_t k = 0; k < entries_.size(); ++k) {
        PlaceOf(entries_[k].node) = static_cast<int>(k);
      }
    } catch (...) {
      places_.map.Clear();
      throw;
    }
  }
  int& PlaceOf(GridNode node) {
    const auto none = [] {
      std::array<int, kTileSide * kTileSide> places;
      places.fill(-1);
      return places;
    };
    return places_.map.Touch(TileOf(node), none)[PlaceInTile(node)];
  }

  std::vector<Entry> entries_;  // in the order in which their nodes were touched
  Places places_;
};

}  // namespace softsoil
