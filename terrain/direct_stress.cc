#include <algorithm>
#include <limits>

#include "terrain/pair_stress.h"
#include "terrain/simd.h"
#include "terrain/stress_field.h"
#include "terrain/worker_pool.h"

namespace softsoil {
namespace {

// One force as one column sees it.
struct ForceOnColumn {
  float z;         // [m]
  float r2;        // [m^2]
  float vertical;  // [N]  downwards
  float moment;    // [N m]  of the horizontal part, r . F_H
};

// Volumes of a column side by side, as many as two AVX2 registers hold.
constexpr int kLanes = 16;
struct Lanes {
  alignas(64) float value[kLanes];
};

// Sums the stress of all forces in the volumes at the heights z [m]; flags those in a near field.
SOFTSOIL_SIMD void SumForces(const PairLaw& law, const ForceOnColumn* forces, int count,
                             const Lanes& z, Lanes* stress, Lanes* near) {
  Lanes sum{}, flag{};
  for (int i = 0; i < count; ++i) {
    const ForceOnColumn force = forces[i];
    // Not `omp simd`: gcc 12 keeps the branches then and makes no vectors, four times as slow.
    for (int lane = 0; lane < kLanes; ++lane) {
      const float depth = force.z - z.value[lane];
      const Ray<float> ray = RayTo(force.r2, depth);
      const float pair = PairStress(law, force.vertical, force.moment, ray);
      sum.value[lane] += InStressCone(law.nu, force.r2, depth) ? pair : 0.0f;
      flag.value[lane] = std::max(flag.value[lane], InNearField(law, ray, depth) ? 1.0f : 0.0f);
    }
  }
  *stress = sum;
  *near = flag;
}

class DirectStress : public StressField {
 public:
  explicit DirectStress(const StressSettings& settings) : threads_(settings.threads) {
    for (const double nu : settings.concentration_factors) {
      laws_.push_back(MakePairLaw(nu, settings.near_field_radius));
    }
  }

  StressBackend BackendFor(const ColumnBatch&, const SurfaceLoad&) const override {
    return StressBackend::kDirect;
  }

  void VerticalStress(const ColumnBatch& batch, const SurfaceLoad& load,
                      std::vector<float>* stress) const override {
    stress->assign(batch.columns() * batch.volumes, 0.0f);
    const int columns = static_cast<int>(batch.columns());
    WorkerPool::Shared().ForEach(columns, threads_, [&](int column) {
      StressOfColumn(batch, load, column, &(*stress)[std::size_t(column) * batch.volumes]);
    });
  }

 private:
  void StressOfColumn(const ColumnBatch& batch, const SurfaceLoad& load, int column,
                      float* stress) const;

  std::vector<PairLaw> laws_;  // by soil
  int threads_;
};

// A column in lanes, heights relative to its top volume: in float they would lose digits far from
// the origin. The lanes beyond the last volume stand far above all forces, out of every cone.
std::vector<Lanes> InLanes(const double* z, int volumes) {
  std::vector<Lanes> lanes((volumes + kLanes - 1) / kLanes);
  for (int k = 0; k < static_cast<int>(lanes.size()) * kLanes; ++k) {
    lanes[k / kLanes].value[k % kLanes] =
        k < volumes ? static_cast<float>(z[k] - z[0]) : std::numeric_limits<float>::max() / 1e30f;
  }
  return lanes;
}

// The forces whose cone reaches a volume of the column at least `lowest` [m] deep, as seen from x,
// y and the height `top` [m].
std::vector<ForceOnColumn> Reaching(const SurfaceLoad& load, const PairLaw& law, double x, double y,
                                    double top, float lowest) {
  std::vector<ForceOnColumn> forces;
  for (const NodeForce& f : load) {
    const double rx = x - f.x, ry = y - f.y;
    const ForceOnColumn force{static_cast<float>(f.z - top), static_cast<float>(rx * rx + ry * ry),
                              static_cast<float>(-f.force_w.z()),
                              static_cast<float>(rx * f.force_w.x() + ry * f.force_w.y())};
    if (InStressCone(law.nu, force.r2, force.z - lowest)) forces.push_back(force);
  }
  return forces;
}

void DirectStress::StressOfColumn(const ColumnBatch& batch, const SurfaceLoad& load, int column,
                                  float* stress) const {
  const PairLaw& law = laws_[batch.soil[column]];
  const double* z = &batch.z[std::size_t(column) * batch.volumes];
  const std::vector<Lanes> heights = InLanes(z, batch.volumes);
  const float own = static_cast<float>(batch.surface_pressure[column]);
  for (std::size_t block = 0; block < heights.size(); ++block) {
    const int first = static_cast<int>(block) * kLanes;
    const int last = std::min(first + kLanes, batch.volumes) - 1;
    const std::vector<ForceOnColumn> forces = Reaching(load, law, batch.x[column], batch.y[column],
                                                       z[0], static_cast<float>(z[last] - z[0]));
    Lanes sum, near;
    SumForces(law, forces.data(), static_cast<int>(forces.size()), heights[block], &sum, &near);
    for (int k = first; k <= last; ++k) {
      stress[k] = near.value[k - first] != 0 ? own : sum.value[k - first];
    }
  }
}

}  // namespace

std::unique_ptr<StressField> MakeDirectStress(const StressSettings& settings) {
  return std::make_unique<DirectStress>(settings);
}

}  // namespace softsoil
