#include "terrain/soil_flow.h"

#include <algorithm>
#include <cmath>

#include "terrain/soil_slopes.h"

namespace softsoil {
namespace {

constexpr double kReach = 0.5;     // [m]      half a wide tire and its berm
constexpr int kSweeps = 10;        // per tick
constexpr double kMostDrag = 100;  // [-]  force along the ground per weight that still tells

double ReadThickness(StateReader& reader) {
  const double thickness = reader.GetFinite();
  reader.Require(std::abs(thickness) <= kFarthest, "a thickness of soil");
  return thickness;
}

GridNode ReadNode(StateReader& reader) {
  const auto node = reader.Get<GridNode>();
  reader.Require(IsOnGrid(TileOf(node)), "a grid node");
  return node;
}

}  // namespace

// The nodes below a wheel since the last tick.
struct SoilFlow::Footprint {
  struct Place {
    int number;                                        // in the field
    double pushed = 0;                                 // [m]
    Eigen::Vector2d drag_w = Eigen::Vector2d::Zero();  // [-]  force along the ground per weight
  };
  std::vector<Place> places;

  // Pushes all soil away, on the nodes around.
  void Spread(FlowField* field) const;
};

void SoilFlow::Footprint::Spread(FlowField* field) const {
  const auto at = [&](const Place& p) {
    return Eigen::Vector2d(field->NodeOf(p.number).i, field->NodeOf(p.number).j);
  };
  Eigen::Vector2d sum(0, 0);  // of integers: the same from both sides
  for (const Place& place : places) sum += at(place);
  const Eigen::Vector2d middle = sum / std::max<double>(places.size(), 1);
  double spread = 0;
  for (const Place& place : places) spread += (at(place) - middle).squaredNorm();
  const double radius = std::max(std::sqrt(spread / std::max<double>(places.size(), 1)), 1.0);
  for (const Place& place : places) {
    if (place.pushed == 0) continue;
    const Eigen::Vector2d outward = (at(place) - middle) / radius;
    field->PushAway(place.number, outward + place.drag_w, place.pushed);
  }
}

SoilFlow::SoilFlow(const SoilMap& soils, double spacing, int sources)
    : soils_(soils),
      reach_(std::max(1, static_cast<int>(std::lround(kReach / spacing)))),
      pushed_(sources) {}

void SoilFlow::Push(int source, NodeSoil soil) {
  pushed_[source].At(soil.node, 0.0) += soil.thickness;
}

void SoilFlow::Reserve(int source, const std::vector<NodeSinkage>& nodes) {
  for (const NodeSinkage& n : nodes) pushed_[source].At(n.node, 0.0);
}

// Nodes that the wheel has pressed deeper, and those that bear it where it has been before: behind
// the axle it rests on its own rut.
SoilFlow::Footprint SoilFlow::FootprintOf(int source, const CompactedSurface& surface,
                                          const SurfaceLoad& load, FlowField* field) const {
  Footprint footprint;
  NodeTable<int> numbers;
  const auto at = [&](GridNode node) -> Footprint::Place& {
    int& number = numbers.At(node, -1);
    if (number < 0) {
      number = static_cast<int>(footprint.places.size());
      footprint.places.push_back({field->Find(node)});
      field->Cover(footprint.places.back().number);
    }
    return footprint.places[number];
  };
  for (const auto& [node, thickness] : pushed_[source].InOrder()) {
    if (thickness > 0) at(node).pushed = thickness;
  }
  for (const NodeForce& f : load) {
    if (f.source != source || f.force_w.z() >= 0 || !surface.Layers(f.node).was_pressed) continue;
    const Eigen::Vector2d along_w = f.force_w.head<2>();
    at(f.node).drag_w = along_w / std::max(-f.force_w.z(), along_w.norm() / kMostDrag);
  }
  return footprint;
}

SoilFlow::Step SoilFlow::Tick(const CompactedSurface& surface, const SurfaceLoad& load) const {
  FlowField field(surface, SoilSlopes(soils_, surface.spacing()));
  std::vector<Footprint> footprints;
  for (std::size_t source = 0; source < pushed_.size(); ++source) {
    footprints.push_back(FootprintOf(static_cast<int>(source), surface, load, &field));
  }
  for (const GridNode node : restless_) {
    const int k = field.Find(node);
    if (!field.IsCovered(k)) field.Disturb(k);
  }
  for (const Footprint& footprint : footprints) footprint.Spread(&field);
  std::vector<FlowField::Taker> caught_up;
  surface.ForEachDisplaced([&](NodeSoil displaced) {
    const int k = field.Find(displaced.node);
    if (displaced.thickness > 0) field.Raise(k, displaced.thickness);
    if (displaced.thickness < 0) caught_up.push_back({k, -displaced.thickness});
  });
  field.TakeFromAround(caught_up, reach_);
  field.Slide(kSweeps);

  Step step{field.Moved(), field.Restless()};
  // Once the wheel has gone on, what stands beside it may slide in.
  for (const Footprint& footprint : footprints) {
    for (const auto& place : footprint.places) step.restless.push_back(field.NodeOf(place.number));
  }
  return step;
}

void SoilFlow::Finish(Step step) {
  for (NodeTable<double>& pushed : pushed_) pushed.Clear();
  restless_ = std::move(step.restless);
}

double SoilFlow::InHand() const {
  double sum = 0;
  for (const NodeTable<double>& pushed : pushed_) {
    for (const auto& entry : pushed.InOrder()) sum += entry.value;
  }
  return sum;
}

std::size_t SoilFlow::MemoryBytes() const {
  std::size_t bytes = restless_.size() * sizeof(GridNode);
  for (const NodeTable<double>& pushed : pushed_) bytes += sizeof pushed + pushed.MemoryBytes();
  return bytes;
}

void SoilFlow::Write(StateWriter& writer) const {
  for (const NodeTable<double>& pushed : pushed_) {
    auto entries = pushed.InOrder();
    entries.erase(std::remove_if(entries.begin(), entries.end(),
                                 [](const auto& entry) { return entry.value == 0; }),
                  entries.end());
    writer.Put(static_cast<std::uint64_t>(entries.size()));
    for (const auto& [node, thickness] : entries) {
      writer.Put(node);
      writer.Put(thickness);
    }
  }
  writer.PutAll(restless_);
}

void SoilFlow::Read(StateReader& reader) {
  for (NodeTable<double>& pushed : pushed_) {
    pushed.Read(reader, sizeof(double), &ReadThickness);
  }
  restless_.resize(reader.Count(sizeof(GridNode)));
  for (GridNode& node : restless_) node = ReadNode(reader);
}

}  // namespace softsoil
