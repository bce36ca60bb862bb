// Columns of a batch side by side on the grid, in patches small enough that no space between
// distant wheels is filled.
#pragma once

#include <vector>

#include "terrain/separable_sum.h"
#include "terrain/stress_field.h"

namespace softsoil {

constexpr int kPatchSide = 96;          // [nodes]  at most
constexpr double kPatchFill = 1.0 / 3;  // share of a patch's nodes whose columns are asked for

// A rectangle of the grid with columns of one soil law.
struct StressPatch {
  int law;
  int i0 = 0, j0 = 0;       // its first node
  int nx = 0, ny = 0;       // [nodes]  ny a multiple of kSumLanes
  double top, bottom;       // [m]  highest and lowest volume
  std::vector<int> column;  // by ix * ny + iy; -1 where none is asked for
};

// Columns at x, y are those of the nodes next to them.
std::vector<StressPatch> MakePatches(const ColumnBatch& batch, const std::vector<int>& law_of_soil,
                                     double spacing);

}  // namespace softsoil
