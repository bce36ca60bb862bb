// Stress along the middle of the tread, from the contacts of many instants.
#pragma once

#include <map>
#include <vector>

#include "plugin/softsoil.h"

namespace softsoil {

struct CentreLinePoint {
  double angle;     // [deg]  from the lowest point of the wheel, positive ahead
  double pressure;  // [Pa]
  double shear;     // [Pa]   along the circumference, positive where it drives forward
};

// Means over degrees of the circumference: the nodes of the tire stand a degree or more apart, and
// pass every angle as the wheel turns.
class CentreLine {
 public:
  // The contacts of one wheel at one instant. Only the nodes nearest to the middle count: one ring,
  // or the two beside it.
  void Add(const std::vector<softsoilContact>& contacts);
  // By rising angle; empty if there was no contact.
  std::vector<CentreLinePoint> Points() const;

 private:
  struct Sum {
    CentreLinePoint point = {};
    int count = 0;
  };
  std::map<int, Sum> sums_;  // by whole degrees
};

}  // namespace softsoil
