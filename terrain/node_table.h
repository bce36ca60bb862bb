// Values at a few grid nodes, found by node.
#pragma once

#include <algorithm>
#include <cstdint>
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
    if (slots_.places.empty()) MakeSlots(kLeastSlots);
    const int place = PlaceOf(node);
    return entries_[place != kNone ? place : Add({node, zero})].value;
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
    std::fill(slots_.places.begin(), slots_.places.end(), kNone);
  }
  std::size_t MemoryBytes() const { return entries_.size() * sizeof(Entry); }

  // Reads nodes that were written in order. read_value(StateReader&) -> Value. Throws InputError.
  template <class ReadValue>
  void Read(StateReader& reader, std::size_t bytes, const ReadValue& read_value) {
    Clear();
    slots_ = Slots();
    for (std::uint64_t left = reader.Count(sizeof(GridNode) + bytes); left > 0; --left) {
      const auto node = reader.Get<GridNode>();
      const bool is_next = entries_.empty() || IsVisitedBefore(entries_.back().node, node);
      reader.Require(is_next && IsOnGrid(TileOf(node)), "a grid node");
      entries_.push_back({node, read_value(reader)});
    }
  }

 private:
  static constexpr int kNone = -1;
  static constexpr std::size_t kLeastSlots = 64;

  // Where in entries_ a node stands: in its own slot or, if others are there, in the next that is
  // free. A power of two of slots, half of them free at least. A copy has none: they are made when
  // they are needed, for most copies are never added to.
  struct Slots {
    Slots() = default;
    Slots(const Slots&) {}
    Slots& operator=(const Slots&) {
      places.clear();
      return *this;
    }
    std::vector<int> places;
  };

  int Add(const Entry& entry) {
    if (2 * (entries_.size() + 1) > slots_.places.size()) MakeSlots(2 * slots_.places.size());
    entries_.push_back(entry);
    return PlaceOf(entry.node) = static_cast<int>(entries_.size()) - 1;
  }

  void MakeSlots(std::size_t least) {
    std::size_t count = least;
    while (count < 2 * entries_.size()) count *= 2;
    slots_.places = std::vector<int>(count, kNone);
    for (std::size_t k = 0; k < entries_.size(); ++k) {
      PlaceOf(entries_[k].node) = static_cast<int>(k);
    }
  }

  // The slot with the place of a node, or the free one where it belongs. Rows of nodes start far
  // from each other, by the golden ratio; along a row they follow one another.
  int& PlaceOf(GridNode node) {
    const std::uint64_t count = slots_.places.size();
    const std::uint32_t row = static_cast<std::uint32_t>(node.i) * 2654435769u;
    for (auto slot = static_cast<std::uint32_t>(row * count >> 32) + node.j;; ++slot) {
      int& place = slots_.places[slot & (count - 1)];
      if (place == kNone) return place;
      const GridNode there = entries_[place].node;
      if (there.i == node.i && there.j == node.j) return place;
    }
  }

  std::vector<Entry> entries_;  // in the order in which their nodes were touched
  Slots slots_;
};

}  // namespace softsoil
