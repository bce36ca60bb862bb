// How far a surface load can compact soil. A bound that no stress exceeds tells which columns the
// load cannot change.
#pragma once

#include <vector>

#include "terrain/surface_load.h"

namespace softsoil {

class LoadReach {
 public:
  // concentration_factor nu [-]. The load must outlive the object.
  LoadReach(const SurfaceLoad& load, double concentration_factor);

  // Bound [Pa] on the vertical stress anywhere below x, y [m]; infinite inside the rectangle that a
  // source covers. And the source that presses most there, -1 without load.
  struct Bound {
    double stress;
    int source;
  };
  Bound At(double x, double y) const;

  // Calls visit(x_min, x_max, y_min, y_max) [m] for rectangles outside of which the bound is
  // below `stress` [Pa] > 0.
  template <class Visit>
  void ForEachRectangle(double stress, const Visit& visit) const {
    const double radius = Radius(stress);
    for (const Footprint& f : footprints_) {
      visit(f.x_min - radius, f.x_max + radius, f.y_min - radius, f.y_max + radius);
    }
  }

 private:
  // Forces of one source as if they stood in every point of their rectangle. A wheel that is thrown
  // far within a soil period has several: between them there is no load.
  struct Footprint {
    int source;
    double x_min, x_max, y_min, y_max;  // [m]
    double reach;                       // [N]  stress <= reach / distance^2
    std::size_t first, last;            // its forces in the load
  };
  static bool IsNear(const Footprint& print, const NodeForce& force);
  // Where rectangles overlap the forces themselves must tell.
  int PressingMost(double x, double y) const;
  double Radius(double stress) const;

  const SurfaceLoad& load_;
  std::vector<Footprint> footprints_;
};

}  // namespace softsoil
