#include "terrain/near_stress.h"

#include <algorithm>
#include <cmath>

#include "terrain/simd.h"

namespace softsoil {
namespace {

constexpr int kLanes = 8;        // columns side by side
constexpr float kSlack = 1e-4f;  // [m]  for rounded lengths, where only what is far is left out
constexpr double kFar = 1e15;  // [m]  a column that is not asked for is that deep below all forces

// Columns side by side.
struct Group {
  int columns, volumes;  // columns: from a volume to the next one
  double x, y_min, y_max, middle;
  const double *y, *top;
  const float* z;
  const float *highest, *lowest;  // by volume
  float *stress, *near;
};

// A force as the columns of a group see it; see terrain/direct_stress.cc, with the same bits.
struct ForceOnGroup {
  float z[kLanes], r2[kLanes], moment[kLanes];
  float vertical;
};

inline ForceOnGroup Seen(const NodeForce& f, const Group& group) {
  ForceOnGroup seen;
  const double rx = group.x - f.x;
  seen.vertical = static_cast<float>(-f.force_w.z());
  for (int lane = 0; lane < kLanes; ++lane) {
    const double ry = group.y[lane] - f.y;
    seen.z[lane] = static_cast<float>(f.z - group.top[lane]);
    seen.r2[lane] = static_cast<float>(rx * rx + ry * ry);
    seen.moment[lane] = static_cast<float>(rx * f.force_w.x() + ry * f.force_w.y());
  }
  return seen;
}

inline void AddVolumes(const NearLaw& law, const ForceOnGroup& force, const Group& group, int k) {
  const float* z = group.z + std::size_t(k) * group.columns;
  float* stress = group.stress + std::size_t(k) * group.columns;
  float* near = group.near + std::size_t(k) * group.columns;
  for (int lane = 0; lane < kLanes; ++lane) {
    const float depth = force.z[lane] - z[lane];
    const Ray<float> ray = RayTo(force.r2[lane], depth);
    const float pair = PairStress(law.pair, force.vertical, force.moment[lane], ray) *
                       (1 - law.share(depth * law.inverse_spacing));
    stress[lane] += InStressCone(law.pair.nu, force.r2[lane], depth) ? pair : 0.0f;
    near[lane] = std::max(near[lane], InNearField(law.pair, ray, depth) ? 1.0f : 0.0f);
  }
}

SOFTSOIL_SIMD void AddForces(const NearLaw& law, const NodeForce* const* forces, int count,
                             const Group& group) {
  int begin = 0;  // the highest volumes that the force reaches; about the same for the next force
  for (int i = 0; i < count; ++i) {
    const NodeForce& f = *forces[i];
    const double ry = std::max({group.y_min - f.y, f.y - group.y_max, 0.0});
    const float r = static_cast<float>(std::sqrt((group.x - f.x) * (group.x - f.x) + ry * ry));
    if (r > law.reach) continue;
    const ForceOnGroup force = Seen(f, group);
    const float z = static_cast<float>(f.z - group.middle);
    const float upper = (r > law.radius ? z - r / law.cone : z) + kSlack, lower = z - law.depth;
    while (begin > 0 && group.lowest[begin - 1] <= upper) --begin;
    while (begin < group.volumes && group.lowest[begin] > upper) ++begin;
    for (int k = begin; k < group.volumes && group.highest[k] > lower; ++k) {
      AddVolumes(law, force, group, k);
    }
  }
}

}  // namespace

NearLaw::NearLaw(double nu, double near_field_radius, double spacing)
    : pair(MakePairLaw(nu, near_field_radius)),
      share(nu),
      inverse_spacing(static_cast<float>(1 / spacing)),
      cone(static_cast<float>(std::sqrt(nu + 1))),
      radius(static_cast<float>(near_field_radius)) {
  depth = std::max(radius, share.all_far() * static_cast<float>(spacing)) + kSlack;
  reach = std::max(radius, cone * depth) + kSlack;
}

NearStress::NearStress(const ColumnBatch& batch, const StressPatch& patch, int ix)
    : columns_(patch.ny),
      volumes_(batch.volumes),
      middle_(patch.top),
      y_(columns_),
      top_(columns_, kFar),
      z_(std::size_t(columns_) * volumes_),
      highest_(z_.size() / kLanes, -kFar),
      lowest_(z_.size() / kLanes, kFar),
      stress_(z_.size()),
      near_(z_.size()) {
  for (int iy = 0; iy < columns_; ++iy) {
    const int column = patch.column[std::size_t(ix) * columns_ + iy];
    if (column < 0) continue;
    x_ = batch.x[column];
    y_[iy] = batch.y[column];
    const double* z = &batch.z[std::size_t(column) * volumes_];
    top_[iy] = z[0];
    for (int k = 0; k < volumes_; ++k) {
      z_[std::size_t(k) * columns_ + iy] = static_cast<float>(z[k] - z[0]);
      const std::size_t in_group = std::size_t(iy / kLanes) * volumes_ + k;
      const float height = static_cast<float>(z[k] - middle_);
      highest_[in_group] = std::max(highest_[in_group], height);
      lowest_[in_group] = std::min(lowest_[in_group], height);
    }
  }
}

void NearStress::Add(const NearLaw& law, const SurfaceLoad& load) {
  std::vector<const NodeForce*> close;
  for (const NodeForce& f : load) {
    if (std::abs(f.x - x_) <= law.reach) close.push_back(&f);
  }
  for (int iy = 0; iy < columns_; iy += kLanes) {
    const std::size_t first = std::size_t(iy / kLanes) * volumes_;
    double y_min = kFar, y_max = -kFar;
    for (int lane = iy; lane < iy + kLanes; ++lane) {
      if (top_[lane] == kFar) continue;
      y_min = std::min(y_min, y_[lane]);
      y_max = std::max(y_max, y_[lane]);
    }
    const auto begin = std::partition_point(
        close.begin(), close.end(), [&](const NodeForce* f) { return f->y < y_min - law.reach; });
    const auto end = std::partition_point(
        begin, close.end(), [&](const NodeForce* f) { return f->y <= y_max + law.reach; });
    if (begin == end) continue;
    AddForces(law, &*begin, static_cast<int>(end - begin),
              {columns_, volumes_, x_, y_min, y_max, middle_, &y_[iy], &top_[iy], &z_[iy],
               &highest_[first], &lowest_[first], &stress_[iy], &near_[iy]});
  }
}

}  // namespace softsoil
