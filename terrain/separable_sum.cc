#include "terrain/separable_sum.h"

#include <algorithm>

#include "terrain/simd.h"

namespace softsoil {
namespace {

constexpr float kNothing = 11;  // exp(-11) = 2e-5 counts as nothing

// Rows within the band around the nodes j0 to j1, as first and one past the last.
struct RowRange {
  int first, last;
};
inline RowRange RowsNear(const Sources& s, int j0, int j1, int band) {
  const auto& rows = s.rows;
  int first = 0, last = static_cast<int>(rows.size());
  while (first < last && rows[first].j < j0 - band) ++first;
  while (first < last && rows[last - 1].j > j1 + band) --last;
  return {first, last};
}

// For every row the sum along x: of what is to be multiplied with the bell along y, in rows of
// `width`, and of what with its slope.
SOFTSOIL_SIMD void SumAlongX(const Sources& s, const Bell& bell, int width, float* sums,
                             RowRange range) {
  for (int r = range.first; r < range.last; ++r) {
    const Sources::Row row = s.rows[r];
    float* with_bell = sums + std::size_t(2 * r) * width;
    float* with_slope = with_bell + width;
    int first = row.first, last = row.first;
    for (int x = 0; x < width; x += kSumLanes) {
      while (first < row.last && s.all[first].i < x - bell.band) ++first;
      while (last < row.last && s.all[last].i <= x + kSumLanes - 1 + bell.band) ++last;
      Eight bell0{}, bell1{}, slope0{}, slope1{};
      for (int f = first; f < last; ++f) {
        const Source& source = s.all[f];
        const float* value = bell.value + x - source.i;
        const float* slope = bell.slope + x - source.i;
        bell0 += source.value * EightAt(value).floats + source.along_x * EightAt(slope).floats;
        bell1 +=
            source.value * EightAt(value + 8).floats + source.along_x * EightAt(slope + 8).floats;
        slope0 += source.along_y * EightAt(value).floats;
        slope1 += source.along_y * EightAt(value + 8).floats;
      }
      EightAt(with_bell + x).floats = bell0;
      EightAt(with_bell + x + 8).floats = bell1;
      EightAt(with_slope + x).floats = slope0;
      EightAt(with_slope + x + 8).floats = slope1;
    }
  }
}

// Four by sixteen nodes at a time, for these sums fit into the registers.
SOFTSOIL_SIMD void SumAlongY(const Sources& s, const Bell& bell, int width, const float* sums,
                             const Target& target) {
  for (int y = 0; y < target.ny; y += kSumLanes) {
    const RowRange range = RowsNear(s, y, y + kSumLanes - 1, bell.band);
    for (int x = 0; x < target.nx; x += 4) {
      float* out = target.sum + std::size_t(x) * target.ny + y;
      Eight a0{}, a1{}, b0{}, b1{}, c0{}, c1{}, d0{}, d1{};
      for (int r = range.first; r < range.last; ++r) {
        const float* u = sums + std::size_t(2 * r) * width + x;
        const float* v = u + width;
        const float* value = bell.value + y - s.rows[r].j;
        const float* slope = bell.slope + y - s.rows[r].j;
        const Eight value0 = EightAt(value).floats, value1 = EightAt(value + 8).floats;
        const Eight slope0 = EightAt(slope).floats, slope1 = EightAt(slope + 8).floats;
        a0 += u[0] * value0 + v[0] * slope0;
        a1 += u[0] * value1 + v[0] * slope1;
        b0 += u[1] * value0 + v[1] * slope0;
        b1 += u[1] * value1 + v[1] * slope1;
        c0 += u[2] * value0 + v[2] * slope0;
        c1 += u[2] * value1 + v[2] * slope1;
        d0 += u[3] * value0 + v[3] * slope0;
        d1 += u[3] * value1 + v[3] * slope1;
      }
      EightAt(out).floats += a0;
      EightAt(out + 8).floats += a1;
      out += target.ny;
      EightAt(out).floats += b0;
      EightAt(out + 8).floats += b1;
      out += target.ny;
      EightAt(out).floats += c0;
      EightAt(out + 8).floats += c1;
      out += target.ny;
      EightAt(out).floats += d0;
      EightAt(out + 8).floats += d1;
    }
  }
}

}  // namespace

Bells::Bells(int first, int last, int farthest)
    : first_(first),
      half_(farthest + kSumLanes),
      values_((last - first + 1) * 2 * (2 * half_ + 1)) {
  for (int m = first; m <= last; ++m) {
    const Bell bell = At(m);
    float* value = &values_[bell.value - values_.data()];
    float* slope = &values_[bell.slope - values_.data()];
    for (int d = 0; d <= std::min(bell.band, half_); ++d) {
      value[d] = value[-d] = static_cast<float>(std::exp(-d * d * std::exp2(-0.5 * m)));
      slope[d] = d * value[d];
      slope[-d] = -slope[d];
    }
  }
}

Bell Bells::At(int m) const {
  const float* value = &values_[std::size_t(m - first_) * 2 * (2 * half_ + 1) + half_];
  return {value, value + 2 * half_ + 1, static_cast<int>(std::sqrt(kNothing * std::exp2(0.5 * m)))};
}

void AddSum(const Sources& sources, const Bell& bell, const Target& target) {
  const int width = InSumLanes(target.nx);
  std::vector<float> sums(sources.rows.size() * 2 * width);
  SumAlongX(sources, bell, width, sums.data(), RowsNear(sources, 0, target.ny - 1, bell.band));
  SumAlongY(sources, bell, width, sums.data(), target);
}

}  // namespace softsoil
