// A tire surface as a cloud of nodes, fixed to the wheel and turning with it.
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "contact/tire.h"

namespace softsoil {

// Arrays by quantity. Tire frame: y along the spin axis, x and z in the plane of the wheel.
struct TireNodes {
  std::vector<Eigen::Vector3d> position_t;  // [m]  from the wheel centre
  std::vector<Eigen::Vector3d> radial_t;    // [-]  outward in the plane of the wheel
  std::vector<Eigen::Vector3d> normal_t;    // [-]  outward
  std::vector<Eigen::Vector3d> tangent_t;   // [-]  along the circumference
  std::vector<Eigen::Vector3d> binormal_t;  // [-]  across the tread: normal x tangent
  std::vector<double> radius;               // [m]  of the circle that the node runs on
  std::vector<double> area;                 // [m^2]  unloaded
  std::vector<double> length;               // [m]  along the circumference
  std::vector<bool> on_lug;                 // else between lugs; empty without lugs
  TireShape shape;                          // of the tire
  int rings = 0;                            // nodes across the tread; from right to left, in order

  std::size_t size() const { return area.size(); }
};

// Nodes at (theta, beta): radius r - r_beta (1 - cos beta), lateral r_beta sin beta, normal
// cos(beta) radial + sin(beta) lateral. About `spacing` [m] > 0 apart; each stands for the exact
// area around it. Of a tire with lugs each stands on a lug or between two, and both kinds together
// for the exact area of theirs.
TireNodes MakeTireNodes(const TireShape& shape, double spacing);

// Area [m^2] of a node of the circle radius [m] once it is pressed in by d [m] (section 4.3).
inline double LoadedArea(double area, double radius, double d) {
  return area * (radius - d) / radius;
}

// Radius [m] of the tire at the lateral distance y [m] from its middle plane, 0 beyond its width.
double RadiusAt(const TireShape& shape, double y);

}  // namespace softsoil
