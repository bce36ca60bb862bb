// Stress of the forces close above a soil volume, summed over pairs; and which volumes lie in the
// near field of a force.
#pragma once

#include <vector>

#include "terrain/far_share.h"
#include "terrain/pair_stress.h"
#include "terrain/stress_patch.h"

namespace softsoil {

// A concentration factor as the sum over near pairs needs it.
struct NearLaw {
  NearLaw(double nu, double near_field_radius, double spacing);

  PairLaw pair;
  FarShare share;
  float inverse_spacing;  // [1/m]
  float cone;             // r / z of its edge
  float radius;           // [m]  R_min
  float depth, reach;     // [m]  of near pairs: most z, most r
};

// The columns of a patch along one line of the grid.
class NearStress {
 public:
  NearStress(const ColumnBatch& batch, const StressPatch& patch, int ix);

  // Adds the near share of the stress of forces, in order of their y.
  void Add(const NearLaw& law, const SurfaceLoad& load);

  // Of the volume k of the column iy; the column must be one that is asked for.
  float Stress(int iy, int k) const { return stress_[k * columns_ + iy]; }  // [Pa]
  bool IsInNearField(int iy, int k) const { return near_[k * columns_ + iy] != 0; }

 private:
  int columns_, volumes_;
  double x_ = 0, middle_;        // [m]  of all columns; a height that heights are relative to
  std::vector<double> y_, top_;  // [m]  of each column; of its highest volume
  std::vector<float> z_;         // [m]  above the column's highest volume; by volume, column
  std::vector<float> highest_, lowest_;  // [m]  of the volumes k of a group of columns
  std::vector<float> stress_, near_;
};

}  // namespace softsoil
