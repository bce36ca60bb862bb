// Stress of the forces some way above a soil volume, by sums of Gaussians: worked out on a few
// horizontal planes at all columns of a patch, and interpolated between the planes.
#pragma once

#include <vector>

#include "terrain/far_share.h"
#include "terrain/gaussian_law.h"
#include "terrain/separable_sum.h"
#include "terrain/stress_patch.h"

namespace softsoil {

// A concentration factor as the far stress needs it.
struct FarLaw {
  explicit FarLaw(double nu) : gaussians(nu), share(nu) {}

  GaussianLaw gaussians;
  FarShare share;
};

class FarStress {
 public:
  // Of the forces, in order of j and then i of their nodes, below the patch. It and the law must
  // outlive the object. spacing [m] of the grid.
  FarStress(const StressPatch& patch, const FarLaw& law, const SurfaceLoad& load, double spacing);

  const StressPatch& patch() const { return patch_; }
  int planes() const { return static_cast<int>(heights_.size()); }
  // Planes may be worked out in any order, at once; all of them before OnPlanes().
  void WorkOut(int plane, const Bells& bells);

  // Stress [Pa] at the columns of one line of the patch, by iy * planes() + plane.
  std::vector<float> OnPlanes(int ix) const;
  // Adds the stress of one of them in the volumes at the heights z [m], from the top down.
  void AddBetween(const float* on_planes, const double* z, int volumes, float* stress) const;

  // What bells WorkOut() needs; see Bells.
  int first_bell() const { return law_.gaussians.At(kFarBegins).first; }
  int last_bell() const;
  int farthest() const { return farthest_; }

 private:
  struct Force {
    int i;                    // node, from the first one of the patch
    float z;                  // [spacings]  above the highest volume of the patch
    float down, east, north;  // [Pa]  on a square of the grid
  };
  struct Interval {      // between two planes
    int first;           // of the four planes that count in it
    float top, inverse;  // [spacings], [1/spacings]  s = (top - z) inverse is 0 to 1
    float weight[4][4];  // of plane p, times s^k: weight[k][p]
  };

  // A force's stress on a plane as sum of Gaussians.
  struct Share {
    bool is_far;
    GaussianSum sum;
  };

  void Add(const NodeForce& force);
  void PlacePlanes(float onset, float lowest);
  void MakeIntervals();
  std::vector<Share> SharesOn(int plane) const;
  void Collect(int m, const std::vector<Share>& shares, Sources* sources) const;

  const StressPatch& patch_;
  const FarLaw& law_;
  double spacing_;
  std::vector<Force> forces_;
  std::vector<Sources::Row> rows_;
  int farthest_ = 0;
  std::vector<float> heights_;  // [spacings]  of the planes, from the top down
  std::vector<Interval> intervals_;
  std::vector<float> stress_;  // [Pa]  plane by plane
};

}  // namespace softsoil
