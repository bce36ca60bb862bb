// The grid nodes that soil moves between in one tick of the soil clock, and how it moves.
#pragma once

#include <Eigen/Core>
#include <array>
#include <utility>
#include <vector>

#include "terrain/compacted_surface.h"
#include "terrain/node_table.h"
#include "terrain/soil_slopes.h"

namespace softsoil {

// A scratch copy of some nodes, loaded from the surface as they are needed. All is done in a fixed
// order, and in thicknesses [m] on cells of equal area, so that what one node loses another gains.
class FlowField {
 public:
  FlowField(const CompactedSurface& surface, SoilSlopes slopes);

  // The number of a node in this field.
  int Find(GridNode node);
  GridNode NodeOf(int k) const { return nodes_[k].node; }

  // A tire is on the node: soil neither slides there nor away.
  void Cover(int k) { nodes_[k].is_covered = true; }
  bool IsCovered(int k) const { return nodes_[k].is_covered; }
  // What is at the node or around it may no longer stand.
  void Disturb(int k);

  // Soil pushed away from a covered node comes to lie on the first one in that direction that is
  // not covered; without a direction, on those all around.
  void PushAway(int k, const Eigen::Vector2d& direction, double thickness);
  // Soil comes to lie on the node; or, where a tire is on it, beside the tire.
  void Raise(int k, double thickness);
  // Nodes take loose soil: each what it has itself, then from the nearest in eight directions that
  // have some, at most `reach` nodes away. Nodes that ask for more than there is share it. Where
  // there is none, the node itself sinks.
  struct Taker {
    int k;
    double thickness;  // [m]
  };
  void TakeFromAround(const std::vector<Taker>& takers, int reach);

  // Lets soil slide, from the disturbed nodes on, in at most so many sweeps. Each node that stands
  // too steep gives to its neighbours an eighth of the excess of height: together the most that
  // does not dig a hole at the node.
  void Slide(int sweeps);
  // Nodes that did not come to rest.
  std::vector<GridNode> Restless() const;

  // The loose soil of all nodes where it has changed.
  std::vector<NodeSoil> Moved() const;

 private:
  static constexpr int kDirections = 8;
  struct Node {
    GridNode node;
    double firm, moved, before;  // [m]
    int soil;
    double change = 0;  // [m]  of the present sweep
    double asked = 0;   // [m]  of it, by takers
    bool is_covered = false, is_disturbed = false, is_changing = false, is_surrounded = false;
    std::array<int, kDirections> neighbours = {-1, -1, -1, -1, -1, -1, -1, -1};  // -1: not loaded

    double Height() const { return firm + moved; }
  };
  using Flows = std::array<double, kDirections>;  // [m]  to the neighbours
  // The height [m] by which soil may stand above a neighbour, and that above which it slides.
  struct Stand {
    double loose, loose_slides, firm, firm_slides;
  };
  using Stands = std::array<Stand, kDirections>;

  void Add(int k, double thickness);
  int Neighbour(int k, int direction);
  void LoadNeighbours(int k);  // so that the node knows all of them
  // First node that is not covered on the way from k.
  int BesideFootprint(int k, const Eigen::Vector2d& direction);
  struct Request {
    double* left;  // [m]  of the taker
    int giver;
    double thickness;  // [m]
  };
  void Ask(const std::vector<int>& givers, double* left, std::vector<Request>* requests);
  void Give(std::vector<Request>* requests);
  Flows Outflow(int k);
  void Change(int k, double thickness);
  void Sweep();

  CompactedSurface surface_;
  SoilSlopes slopes_;
  std::vector<Stands> stands_;  // by soil
  std::vector<Node> nodes_;
  NodeTable<int> numbers_;
  std::vector<int> disturbed_, changing_;
};

}  // namespace softsoil
