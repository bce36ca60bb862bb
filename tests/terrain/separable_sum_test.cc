#include "terrain/separable_sum.h"

#include <gtest/gtest.h>

namespace softsoil {
namespace {

constexpr int kNx = 21, kNy = 32, kFarthest = 90;

// In and around the nodes at which is summed.
Sources SomeSources() {
  Sources sources;
  for (const int j : {-40, -3, 0, 7, 8, 31, 60}) {
    const int first = static_cast<int>(sources.all.size());
    for (const int i : {-50, -1, 0, 5, 6, 20, 21, 70}) {
      sources.all.push_back({i, 1 + 0.1f * i, 0.3f * j, 2.0f - i});
    }
    sources.rows.push_back({j, first, static_cast<int>(sources.all.size())});
  }
  return sources;
}

double SumAt(const Sources& sources, int m, int x, int y) {
  double sum = 0;
  for (const Sources::Row& row : sources.rows) {
    for (int f = row.first; f < row.last; ++f) {
      const Source& s = sources.all[f];
      const double dx = x - s.i, dy = y - row.j;
      sum += (s.value + s.along_x * dx + s.along_y * dy) *
             std::exp(-(dx * dx + dy * dy) / std::exp2(0.5 * m));
    }
  }
  return sum;
}

TEST(SeparableSum, IsTheSumOverAllSources) {
  const Sources sources = SomeSources();
  const Bells bells(-4, 24, kFarthest);
  for (const int m : {-4, -1, 0, 3, 8, 13, 24}) {
    std::vector<float> sum(SumRows(kNx) * kNy, 1.0f);
    AddSum(sources, bells.At(m), {kNx, kNy, sum.data()});
    double most = 0;
    for (int k = 0; k < kNx * kNy; ++k) {
      most = std::max(most, std::abs(SumAt(sources, m, k / kNy, k % kNy)));
    }
    ASSERT_GT(most, 1);
    for (int k = 0; k < kNx * kNy; ++k) {
      EXPECT_NEAR(sum[k], 1 + SumAt(sources, m, k / kNy, k % kNy), 1e-3 * most) << m << ", " << k;
    }
  }
}

TEST(SeparableSum, OfNoSourcesIsZero) {
  const Bells bells(0, 0, 4);
  std::vector<float> sum(SumRows(1) * kSumLanes);
  AddSum({}, bells.At(0), {1, kSumLanes, sum.data()});
  EXPECT_EQ(sum, std::vector<float>(sum.size(), 0.0f));
}

}  // namespace
}  // namespace softsoil
