#include "terrain/far_stress.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "terrain/simd.h"

namespace softsoil {
namespace {

// Distance of planes: fine enough for the share that is far to be interpolated, and below all
// forces by this part of the depth, for there the stress changes more slowly.
constexpr float kLeastDistance = 0.5f, kPartOfDepth = 0.3f;
constexpr int kPlanesPerInterval = 4;
constexpr int kMostPlanes = 2000;  // of columns that no ground has

int Outside(int k, int n) { return std::max({0, -k, k - (n - 1)}); }

}  // namespace

FarStress::FarStress(const StressPatch& patch, const FarLaw& law, const SurfaceLoad& load,
                     double spacing)
    : patch_(patch), law_(law), spacing_(spacing) {
  const float bottom = static_cast<float>((patch.bottom - patch.top) / spacing);
  float onset = -std::numeric_limits<float>::max(), lowest = -onset;
  for (const NodeForce& f : load) {
    const int i = f.node.i - patch.i0, j = f.node.j - patch.j0;
    const float z = static_cast<float>((f.z - patch.top) / spacing);
    const float cone_depth =
        std::hypot(float(Outside(i, patch.nx)), float(Outside(j, patch.ny))) / law.gaussians.cone();
    const float begin = z - std::max(kFarBegins, cone_depth);
    if (begin <= bottom) continue;
    onset = std::max(onset, begin);
    lowest = std::min(lowest, z + cone_depth);
    Add(f);
  }
  if (forces_.empty()) return;
  PlacePlanes(std::min(onset + kLeastDistance, 0.0f), lowest);
  MakeIntervals();
  stress_.resize(heights_.size() * SumRows(patch.nx) * patch.ny);
}

void FarStress::Add(const NodeForce& f) {
  const int i = f.node.i - patch_.i0, j = f.node.j - patch_.j0;
  farthest_ = std::max(
      {farthest_, std::abs(i), std::abs(j), std::abs(i - patch_.nx), std::abs(j - patch_.ny)});
  const int count = static_cast<int>(forces_.size());
  if (rows_.empty() || rows_.back().j != j) rows_.push_back({j, count, count});
  ++rows_.back().last;
  const double area = spacing_ * spacing_;
  forces_.push_back({i, static_cast<float>((f.z - patch_.top) / spacing_),
                     static_cast<float>(-f.force_w.z() / area),
                     static_cast<float>(f.force_w.x() / area),
                     static_cast<float>(f.force_w.y() / area)});
}

// From the height where the far stress begins down to the bottom; more closely as far as beside
// the lowest force.
void FarStress::PlacePlanes(float onset, float lowest) {
  const float bottom = static_cast<float>((patch_.bottom - patch_.top) / spacing_);
  const float least = std::max(kLeastDistance, (onset - bottom) / kMostPlanes);
  float z = onset;
  heights_.push_back(z);
  while (z > bottom || heights_.size() < kPlanesPerInterval) {
    const float depth = lowest - z;
    z -= std::max(least, kPartOfDepth * (depth - law_.share.all_far() + 2));
    heights_.push_back(z);
  }
}

// Lagrange's polynomials over the four planes nearest to an interval.
void FarStress::MakeIntervals() {
  for (int p = 0; p + 1 < planes(); ++p) {
    Interval interval{};
    interval.first = std::clamp(p - 1, 0, planes() - kPlanesPerInterval);
    interval.top = heights_[p];
    interval.inverse = 1 / (heights_[p] - heights_[p + 1]);
    const auto place = [&](int q) { return (interval.top - heights_[q]) * interval.inverse; };
    for (int own = 0; own < kPlanesPerInterval; ++own) {
      float polynomial[4] = {1, 0, 0, 0};
      for (int other = 0; other < kPlanesPerInterval; ++other) {
        if (other == own) continue;
        const float zero = place(interval.first + other);
        const float scale = 1 / (place(interval.first + own) - zero);
        for (int k = 3; k > 0; --k) {
          polynomial[k] = (polynomial[k - 1] - zero * polynomial[k]) * scale;
        }
        polynomial[0] *= -zero * scale;
      }
      for (int k = 0; k < 4; ++k) interval.weight[k][own] = polynomial[k];
    }
    intervals_.push_back(interval);
  }
}

int FarStress::last_bell() const {
  float highest = heights_.front();
  for (const Force& force : forces_) highest = std::max(highest, force.z);
  return law_.gaussians.At(highest - heights_.back()).first + kGaussians - 1;
}

std::vector<FarStress::Share> FarStress::SharesOn(int plane) const {
  std::vector<Share> shares(forces_.size());
  for (std::size_t f = 0; f < forces_.size(); ++f) {
    if (f > 0 && forces_[f].z == forces_[f - 1].z) {
      shares[f] = shares[f - 1];
      continue;
    }
    const float depth = forces_[f].z - heights_[plane];
    const float share = law_.share(depth);
    shares[f].is_far = share > 0;
    if (share <= 0) continue;
    GaussianSum& sum = shares[f].sum;
    sum = law_.gaussians.At(depth);
    for (float& weight : sum.vertical) weight *= share;
    for (float& weight : sum.horizontal) weight *= share;
  }
  return shares;
}

// The forces whose sum has the Gaussian m.
void FarStress::Collect(int m, const std::vector<Share>& shares, Sources* sources) const {
  sources->rows.clear();
  sources->all.resize(forces_.size());
  int count = 0;
  for (const Sources::Row& row : rows_) {
    const int first = count;
    for (int f = row.first; f < row.last; ++f) {
      const GaussianSum& sum = shares[f].sum;
      const int k = m - sum.first;
      if (!shares[f].is_far || k < 0 || k >= kGaussians) continue;
      const Force& force = forces_[f];
      sources->all[count++] = {force.i, sum.vertical[k] * force.down,
                               sum.horizontal[k] * force.east, sum.horizontal[k] * force.north};
    }
    if (count > first) sources->rows.push_back({row.j, first, count});
  }
}

void FarStress::WorkOut(int plane, const Bells& bells) {
  const std::vector<Share> shares = SharesOn(plane);
  int first = std::numeric_limits<int>::max(), last = std::numeric_limits<int>::min();
  for (const Share& share : shares) {
    if (!share.is_far) continue;
    first = std::min(first, share.sum.first);
    last = std::max(last, share.sum.first + kGaussians - 1);
  }
  const std::size_t area = std::size_t(SumRows(patch_.nx)) * patch_.ny;
  Sources sources;
  for (int m = first; m <= last; ++m) {
    Collect(m, shares, &sources);
    AddSum(sources, bells.At(m), {patch_.nx, patch_.ny, &stress_[plane * area]});
  }
}

std::vector<float> FarStress::OnPlanes(int ix) const {
  const std::size_t area = std::size_t(SumRows(patch_.nx)) * patch_.ny;
  std::vector<float> columns(heights_.size() * patch_.ny);
  for (std::size_t q = 0; q < heights_.size(); ++q) {
    const float* plane = &stress_[q * area + std::size_t(ix) * patch_.ny];
    for (int iy = 0; iy < patch_.ny; ++iy) columns[iy * heights_.size() + q] = plane[iy];
  }
  return columns;
}

void FarStress::AddBetween(const float* on_planes, const double* z, int volumes,
                           float* stress) const {
  const int last = static_cast<int>(intervals_.size()) - 1;
  const double inverse = 1 / spacing_;
  int p = 0;
  for (int k = 0; k < volumes; ++k) {
    const float height = static_cast<float>((z[k] - patch_.top) * inverse);
    if (height > heights_[0]) continue;
    while (p < last && height < heights_[p + 1]) ++p;
    const Interval& interval = intervals_[p];
    const float s = (interval.top - height) * interval.inverse;
    const auto weight = [&](int power) { return FourAt(interval.weight[power]).floats; };
    const Four part = (((weight(3) * s + weight(2)) * s + weight(1)) * s + weight(0)) *
                      FourAt(on_planes + interval.first).floats;
    stress[k] += (part[0] + part[1]) + (part[2] + part[3]);
  }
}

}  // namespace softsoil
