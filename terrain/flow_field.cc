#include "terrain/flow_field.h"

#include <cmath>

namespace softsoil {
namespace {

// Neighbours all around; the opposite of each direction is 7 less it.
constexpr GridNode kSteps[8] = {{-1, -1}, {-1, 0}, {-1, 1}, {0, -1},
                                {0, 1},   {1, -1}, {1, 0},  {1, 1}};
double Length(GridNode step) { return step.i != 0 && step.j != 0 ? std::sqrt(2.0) : 1.0; }

constexpr double kShare = 1.0 / 8;    // [-]  of an excess of height that slides in one sweep
constexpr double kTolerance = 0.001;  // [-]  slope that is not levelled
constexpr double kLeastDirection = 1e-6;

}  // namespace

FlowField::FlowField(const CompactedSurface& surface, SoilSlopes slopes)
    : surface_(surface), slopes_(std::move(slopes)) {
  for (int soil = 0; soil < slopes_.size(); ++soil) {
    Stands stands;
    for (int d = 0; d < kDirections; ++d) {
      const double way = surface.spacing() * Length(kSteps[d]), flat = kTolerance * way;
      const double loose = slopes_[soil].repose * way, firm = std::max(loose, slopes_[soil].wall);
      stands[d] = {loose, loose + flat, firm, firm + flat};
    }
    stands_.push_back(stands);
  }
}

int FlowField::Find(GridNode node) {
  int& number = numbers_.At(node, -1);
  if (number < 0) {
    const NodeLayers layers = surface_.Layers(node);
    number = static_cast<int>(nodes_.size());
    nodes_.push_back({node, layers.firm, layers.moved, layers.moved, slopes_.SoilAt(node)});
  }
  return number;
}

int FlowField::Neighbour(int k, int direction) {
  const int known = nodes_[k].neighbours[direction];
  if (known >= 0) return known;
  const GridNode node = nodes_[k].node, step = kSteps[direction];
  const int neighbour = Find({node.i + step.i, node.j + step.j});
  nodes_[k].neighbours[direction] = neighbour;
  nodes_[neighbour].neighbours[kDirections - 1 - direction] = k;
  return neighbour;
}

void FlowField::LoadNeighbours(int k) {
  if (nodes_[k].is_surrounded) return;
  for (int d = 0; d < kDirections; ++d) Neighbour(k, d);
  nodes_[k].is_surrounded = true;
}

void FlowField::Disturb(int k) {
  const auto add = [this](int n) {
    if (nodes_[n].is_disturbed) return;
    nodes_[n].is_disturbed = true;
    disturbed_.push_back(n);
  };
  LoadNeighbours(k);
  add(k);
  for (const int n : nodes_[k].neighbours) add(n);
}

void FlowField::Add(int k, double thickness) {
  nodes_[k].moved += thickness;
  Disturb(k);
}

int FlowField::BesideFootprint(int k, const Eigen::Vector2d& direction) {
  const GridNode from = nodes_[k].node;
  // From the node itself, so that mirrored directions lead to mirrored nodes.
  for (int way = 1;; ++way) {
    const int i = static_cast<int>(std::lround(way * direction.x()));
    const int j = static_cast<int>(std::lround(way * direction.y()));
    const int beside = Find({from.i + i, from.j + j});
    if (!nodes_[beside].is_covered) return beside;
  }
}

void FlowField::PushAway(int k, const Eigen::Vector2d& direction, double thickness) {
  const double length = direction.norm();
  if (length > kLeastDirection) {
    Add(BesideFootprint(k, direction / length), thickness);
    return;
  }
  for (const GridNode step : kSteps) {
    const Eigen::Vector2d outward(step.i / Length(step), step.j / Length(step));
    Add(BesideFootprint(k, outward), thickness / kDirections);
  }
}

void FlowField::Raise(int k, double thickness) {
  if (IsCovered(k)) {
    PushAway(k, Eigen::Vector2d::Zero(), thickness);
  } else {
    Add(k, thickness);
  }
}

// In proportion to what the givers have.
void FlowField::Ask(const std::vector<int>& givers, double* left, std::vector<Request>* requests) {
  double there = 0;
  for (const int k : givers) there += nodes_[k].moved;
  for (const int k : givers) {
    const double thickness = *left * nodes_[k].moved / there;
    nodes_[k].asked += thickness;
    requests->push_back({left, k, thickness});
  }
}

void FlowField::Give(std::vector<Request>* requests) {
  for (Request& r : *requests) {
    r.thickness *= std::min(1.0, nodes_[r.giver].moved / nodes_[r.giver].asked);
  }
  for (const Request& r : *requests) {
    nodes_[r.giver].asked = 0;
    Add(r.giver, -r.thickness);
    *r.left -= r.thickness;
  }
  requests->clear();
}

void FlowField::TakeFromAround(const std::vector<Taker>& takers, int reach) {
  struct Search {
    int k;
    double left;                        // [m]
    std::array<int, kDirections> ends;  // how far it has come
  };
  std::vector<Search> searches;
  for (const auto& [k, thickness] : takers) {
    searches.push_back({k, thickness, {}});
    searches.back().ends.fill(k);
  }
  const auto has_loose = [this](int n) { return nodes_[n].moved > 0; };
  std::vector<Request> requests;
  for (Search& search : searches) {
    if (has_loose(search.k)) Ask({search.k}, &search.left, &requests);
  }
  Give(&requests);
  std::vector<int> givers;
  for (int way = 1; way <= reach; ++way) {
    for (Search& search : searches) {
      if (search.left <= 0) continue;
      givers.clear();
      for (int d = 0; d < kDirections; ++d) {
        int& end = search.ends[d];
        end = Neighbour(end, d);
        if (!nodes_[end].is_covered && has_loose(end)) givers.push_back(end);
      }
      Ask(givers, &search.left, &requests);
    }
    Give(&requests);
  }
  for (const Search& search : searches) {
    if (search.left != 0) Add(search.k, -search.left);
  }
}

// What the neighbours get. Loose soil goes first; firm soil follows where a wall is too high.
FlowField::Flows FlowField::Outflow(int k) {
  LoadNeighbours(k);
  const Node& from = nodes_[k];
  const Stands& stands = stands_[from.soil];
  Flows drops, flows;
  for (int d = 0; d < kDirections; ++d) {
    const Node& to = nodes_[from.neighbours[d]];
    drops[d] = to.is_covered ? 0 : from.Height() - to.Height();
  }
  double wanted = 0;
  for (int d = 0; d < kDirections; ++d) {
    const Stand& stand = stands[d];
    flows[d] = drops[d] > stand.loose_slides ? kShare * (drops[d] - stand.loose) : 0;
    wanted += flows[d];
  }
  const double there = std::max(from.moved, 0.0);
  if (wanted <= there) return flows;
  const double share = there / wanted;
  for (int d = 0; d < kDirections; ++d) {
    const Stand& stand = stands[d];
    const double firm = drops[d] > stand.firm_slides ? kShare * (drops[d] - stand.firm) : 0;
    flows[d] = share * flows[d] + (1 - share) * firm;
  }
  return flows;
}

void FlowField::Change(int k, double thickness) {
  Node& node = nodes_[k];
  node.change += thickness;
  if (node.is_changing) return;
  node.is_changing = true;
  changing_.push_back(k);
}

void FlowField::Sweep() {
  changing_.clear();
  for (const int k : disturbed_) {
    nodes_[k].is_disturbed = false;
    if (nodes_[k].is_covered) continue;
    const Flows flows = Outflow(k);
    for (int d = 0; d < kDirections; ++d) {
      if (!(flows[d] > 0)) continue;
      Change(k, -flows[d]);
      Change(nodes_[k].neighbours[d], flows[d]);
    }
  }
  disturbed_.clear();
  for (const int k : changing_) {
    nodes_[k].moved += nodes_[k].change;
    nodes_[k].change = 0;
    nodes_[k].is_changing = false;
    Disturb(k);
  }
}

void FlowField::Slide(int sweeps) {
  changing_.clear();
  for (int sweep = 0; sweep < sweeps && !disturbed_.empty(); ++sweep) Sweep();
}

std::vector<GridNode> FlowField::Restless() const {
  std::vector<GridNode> restless;
  for (const int k : changing_) restless.push_back(nodes_[k].node);
  return restless;
}

std::vector<NodeSoil> FlowField::Moved() const {
  std::vector<NodeSoil> moved;
  for (const Node& node : nodes_) {
    if (node.moved != node.before) moved.push_back({node.node, node.moved});
  }
  return moved;
}

}  // namespace softsoil
