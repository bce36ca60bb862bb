// Stress along the middle of the tread, from the contacts of many instants.
#pragma once

#include <map>
#include <vector>

#include "contact/tire_nodes.h"
#include "plugin/softsoil.h"

namespace softsoil {

struct CentreLinePoint {
  double angle;     // [deg]  from the lowest point of the wheel, positive ahead
  double pressure;  // [Pa]
  double shear;     // [Pa]   along the circumference, positive where it drives forward
};

// Nodes of a tire in rings, `spacing` [m] apart; none of a mesh, whose nodes stand in none.
TireNodes RingsOf(const Tire& tire, double spacing);

// Mean over instants at every half degree between two whole ones. At an instant stress is linear
// from node to node of a ring, and 0 at a node that does not touch. The middle is one ring of
// nodes, or the mean of the two beside it.
class CentreLine {
 public:
  // `nodes` of the tire, RingsOf(). Of none there are no points.
  explicit CentreLine(const TireNodes& nodes);
  // The contacts of the tire at one instant.
  void Add(const std::vector<softsoilContact>& contacts);
  // By rising angle; empty if there was no contact.
  std::vector<CentreLinePoint> Points() const;

 private:
  struct Sum {
    double pressure = 0, shear = 0;  // [Pa]
  };
  double middle_;            // [m]    distance of the ring or rings from the middle plane
  double pitch_;             // [deg]  between nodes of a ring
  int rings_;                // 1 or 2
  long instants_ = 0;        //
  std::map<int, Sum> sums_;  // by whole degrees
};

}  // namespace softsoil
