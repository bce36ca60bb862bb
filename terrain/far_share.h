// The share of a pair's stress that counts as far, and is worked out for many pairs at once. The
// rest is near; it is left to a sum over pairs. In between the share rises smoothly, for what is
// far is interpolated.
#pragma once

#include <algorithm>

namespace softsoil {

constexpr float kFarBegins = 1;     // [grid spacings]  depth below the force
constexpr float kNearReaches = 11;  // [grid spacings]  beside it, at the edge of the stress cone

class FarShare {
 public:
  explicit FarShare(double concentration_factor)
      : all_far_(std::max(4.2f, static_cast<float>(26 / (concentration_factor + 1)))),
        slope_(1 / (all_far_ - kFarBegins)) {}

  // Depth [grid spacings] from which on all is far.
  float all_far() const { return all_far_; }

  float operator()(float depth) const {
    const float t = (depth - kFarBegins) * slope_;
    const float u = t < 0 ? 0 : t > 1 ? 1 : t;
    return u * u * u * (10 + u * (6 * u - 15));
  }

 private:
  float all_far_, slope_;
};

}  // namespace softsoil
