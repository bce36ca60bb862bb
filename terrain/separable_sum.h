// The sum of Gaussians around many nodes of a grid, at many nodes: along x first, then along y.
#pragma once

#include <cmath>
#include <vector>

namespace softsoil {

constexpr int kSumLanes = 16;  // nodes along x and along y that are dealt with together
// Nodes rounded up to whole lanes.
constexpr int InSumLanes(int nodes) { return (nodes + kSumLanes - 1) / kSumLanes * kSumLanes; }

// exp(-d^2 / L^2), L^2 = 2^(m / 2), and d times that, for whole distances d. Lengths in grid
// spacings.
struct Bell {
  const float* value;  // at d = 0
  const float* slope;
  int band;  // beyond it all is zero
};

class Bells {
 public:
  // m from `first` to `last`, distances up to `farthest`.
  Bells(int first, int last, int farthest);
  Bell At(int m) const;

 private:
  int first_, half_;
  std::vector<float> values_;
};

// What stands at a node: `value` times the bell along x and along y; along_x and along_y times the
// slope along their axis and the bell along the other.
struct Source {
  int i;
  float value, along_x, along_y;
};

// In order of their nodes' j and then i.
struct Sources {
  struct Row {  // of equal j
    int j, first, last;
  };
  std::vector<Row> rows;
  std::vector<Source> all;
};

// Nodes 0 to nx - 1 and 0 to ny - 1.
struct Target {
  int nx, ny;  // ny a multiple of kSumLanes
  float* sum;  // by ix * ny + iy, room for SumRows(nx) rows
};
inline int SumRows(int nx) { return (nx + 3) / 4 * 4; }

// Adds one Gaussian's sum.
void AddSum(const Sources& sources, const Bell& bell, const Target& target);

}  // namespace softsoil
