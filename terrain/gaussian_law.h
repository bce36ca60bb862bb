// The laws of terrain/point_load.h, cut off at the stress cone, as sums of Gaussians. These are
// separable: exp(-r^2 / L^2) = exp(-x^2 / L^2) exp(-y^2 / L^2), so that the sum over all forces is
// one along y after one along x.
#pragma once

#include <array>
#include <vector>

namespace softsoil {

constexpr int kGaussians = 8;

// Over a horizontal plane, with lengths in units of one's own: of a unit force
//   vertical     stress = sum_k vertical[k] exp(-r^2 / L_k^2)
//   horizontal   stress = sum_k horizontal[k] exp(-r^2 / L_k^2) r . F
// with L_k^2 = 2^((first + k) / 2): the same Gaussians at any depth.
struct GaussianSum {
  int first;
  std::array<float, kGaussians> vertical, horizontal;
};

// A concentration factor's sums. The error in the middle of a circle of equal forces is below
// 0.7 % of the pressure, wherever its edge, and mostly far below: sums of Gaussians round off the
// edge of the cone.
class GaussianLaw {
 public:
  explicit GaussianLaw(double concentration_factor);

  GaussianSum At(float depth) const;
  float cone() const { return cone_; }  // r / z of its edge

 private:
  struct Entry {
    std::array<float, 2 * kGaussians> weight;  // vertical, horizontal; at depth 1
  };
  float cone_;
  std::vector<Entry> entries_;  // over a quarter of an octave of the depth
};

}  // namespace softsoil
