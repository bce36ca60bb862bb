// The surface as it will be once the soil below it has compacted: asked before anything changes.
#pragma once

#include <algorithm>
#include <vector>

#include "terrain/surface.h"

namespace softsoil {

class CompactedSurface {
 public:
  // With the compaction that there is. The surface must outlive the object.
  CompactedSurface(const Surface& surface) : surface_(surface) {}
  // With another one of some columns, as a soil update gives it; it must outlive the object too.
  CompactedSurface(const Surface& surface, const std::vector<NodeSinkage>& compaction)
      : surface_(surface),
        first_(compaction.data()),
        last_(compaction.data() + compaction.size()) {}

  double spacing() const { return surface_.spacing(); }
  NodeLayers Layers(GridNode node) const {
    const auto before = [](const NodeSinkage& c, GridNode n) { return IsBeforeByTile(c.node, n); };
    const NodeSinkage* c = std::lower_bound(first_, last_, node, before);
    return c == last_ || IsBeforeByTile(node, c->node) ? surface_.Layers(node)
                                                       : surface_.LayersWith(*c);
  }
  double Height(GridNode node) const {  // [m]
    const NodeLayers layers = Layers(node);
    return layers.firm + layers.moved;
  }

  // visit(NodeSoil) where the displaced thickness grows, and by how much [m]; below 0 where
  // compaction catches up with bearing sinkage.
  template <class Visit>
  void ForEachDisplaced(const Visit& visit) const {
    for (const NodeSinkage* c = first_; c != last_; ++c) {
      const double displaced = surface_.DisplacedBy(*c);
      if (displaced != 0) visit(NodeSoil{c->node, displaced});
    }
  }

 private:
  const Surface& surface_;
  const NodeSinkage* first_ = nullptr;
  const NodeSinkage* last_ = nullptr;
};

}  // namespace softsoil
