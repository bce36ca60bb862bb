// Displaced soil: what wheels press away beyond compaction rises as berms beside and before them,
// is pushed along, and slides back to the angle of repose. Its volume is kept; only compaction
// loses volume.
#pragma once

#include <vector>

#include "terrain/flow_field.h"
#include "terrain/node_table.h"
#include "terrain/soil_map.h"
#include "terrain/surface_load.h"

namespace softsoil {

// Soil that is pushed away is in hand until the next tick of the soil clock. Then it leaves the
// footprint of its wheel: outward, as from under a plate that sinks, where the soil's speed grows
// with the distance from the middle; and besides the way in which the wheel presses and shears the
// ground there. So a rolling wheel leaves berms on both sides, a sliding one piles soil up ahead.
//
// Where compaction catches up with bearing sinkage, less soil was displaced than had been thought:
// that much is taken back from the loose soil around.
class SoilFlow {
 public:
  // spacing [m] of the grid.
  SoilFlow(const SoilMap& soils, double spacing, int sources);

  // Soil that a source has pushed away from a node. Cannot fail after Reserve() for the same nodes,
  // which changes nothing else.
  void Push(int source, NodeSoil soil);
  void Reserve(int source, const std::vector<NodeSinkage>& nodes);

  // What a tick does, at which the compaction of the surface comes to be as it is given here, under
  // the mean load since the last one. A question: changes nothing.
  struct Step {
    std::vector<NodeSoil> moved;     // for Surface::SetMoved()
    std::vector<GridNode> restless;  // that may go on moving
  };
  Step Tick(const CompactedSurface& surface, const SurfaceLoad& load) const;
  // The tick has been done. Cannot fail.
  void Finish(Step step);

  double InHand() const;  // [m]  sum of thicknesses
  std::size_t MemoryBytes() const;
  void Write(StateWriter& writer) const;
  void Read(StateReader& reader);  // throws InputError

 private:
  struct Footprint;
  Footprint FootprintOf(int source, const CompactedSurface& surface, const SurfaceLoad& load,
                        FlowField* field) const;

  SoilMap soils_;
  int reach_;                              // [nodes]  from where soil is taken back
  std::vector<NodeTable<double>> pushed_;  // [m]  by source
  std::vector<GridNode> restless_;
};

}  // namespace softsoil
