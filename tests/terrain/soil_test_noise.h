// Soil tests made from known parameters, exact or with noise.
#pragma once

#include <random>

#include "terrain/bearing_fit.h"
#include "terrain/shear_fit.h"

namespace softsoil {

// Normal noise with a fixed seed.
class Noise {
 public:
  explicit Noise(unsigned seed) : random_(seed) {}
  double operator()() { return normal_(random_); }

 private:
  std::mt19937 random_;
  std::normal_distribution<double> normal_;
};

// Multiplies each reading by 1 + share * normal: what soil does from place to place.
inline std::vector<double> WithRelativeNoise(std::vector<double> readings, double share,
                                             Noise* noise) {
  for (double& value : readings) value *= 1 + share * (*noise)();
  return readings;
}

// Adds size * normal to each reading: what a load cell does.
inline std::vector<double> WithNoise(std::vector<double> readings, double size, Noise* noise) {
  for (double& value : readings) value += size * (*noise)();
  return readings;
}

}  // namespace softsoil
