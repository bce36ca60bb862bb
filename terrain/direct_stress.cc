#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <limits>

#include "terrain/point_load.h"
#include "terrain/stress_field.h"
#include "terrain/worker_pool.h"

// Where the processor has AVX2 the inner loop uses it. Every lane is a volume with a sum of its
// own, so the bits do not depend on the width.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_THREAD__)
#define SOFTSOIL_SIMD __attribute__((target_clones("avx2", "default")))
#else
#define SOFTSOIL_SIMD
#endif

namespace softsoil {
namespace {

// cos^nu(theta) = t^(nu/2), t = z^2 / R^2, as a polynomial in t, for real nu without a power per
// pair. Inside the cone t >= 1/(nu + 2), where the function is smooth: Chebyshev interpolation of
// this degree is good to float accuracy.
constexpr int kDegree = 7;
using CosinePolynomial = std::array<float, kDegree + 1>;  // coefficients in s = 2 (t - mid) / span

struct CosineSeries {
  float middle, scale;  // s = (t - middle) * scale, in [-1, 1]
  CosinePolynomial coefficient;
};

// Coefficients of the monomials s^k of the interpolating Chebyshev sum.
CosineSeries FitCosinePower(double nu) {
  const double low = 1 / (nu + 2), high = 1;
  const double middle = (low + high) / 2, half_span = (high - low) / 2;
  constexpr int n = kDegree + 1;
  std::array<double, n> chebyshev{};
  for (int k = 0; k < n; ++k) {
    for (int point = 0; point < n; ++point) {
      const double angle = kPi * (point + 0.5) / n;
      chebyshev[k] +=
          2.0 / n * std::pow(middle + half_span * std::cos(angle), nu / 2) * std::cos(k * angle);
    }
  }
  chebyshev[0] /= 2;
  std::array<double, n> sum{}, previous{}, current{};  // T_(k-1) and T_k as monomials
  current[0] = 1;
  for (int k = 0; k < n; ++k) {
    for (int power = 0; power < n; ++power) sum[power] += chebyshev[k] * current[power];
    std::array<double, n> next{};
    for (int power = 0; power + 1 < n; ++power) next[power + 1] = (k == 0 ? 1 : 2) * current[power];
    if (k > 0) {
      for (int power = 0; power < n; ++power) next[power] -= previous[power];
    }
    previous = current;
    current = next;
  }
  CosineSeries series{static_cast<float>(middle), static_cast<float>(1 / half_span), {}};
  for (int power = 0; power < n; ++power) {
    series.coefficient[power] = static_cast<float>(sum[power]);
  }
  return series;
}

// Horner's rule from the highest power down to k, unrolled, for the loop around it is the one to
// become SIMD.
template <int k>
inline float Horner(const CosinePolynomial& coefficient, float s) {
  if constexpr (k == kDegree) {
    return coefficient[k];
  } else {
    return Horner<k + 1>(coefficient, s) * s + coefficient[k];
  }
}

inline float CosinePower(const CosineSeries& series, float cosine_squared) {
  return Horner<0>(series.coefficient, (cosine_squared - series.middle) * series.scale);
}

// One force as one column sees it.
struct ForceOnColumn {
  float z;         // [m]
  float r2;        // [m^2]
  float vertical;  // [N]  downwards
  float moment;    // [N m]  of the horizontal part, r . F_H
};

struct Law {
  float nu;
  float inverse_near2;  // [1/m^2]  1 / R_min^2
  CosineSeries cosine;
};

// `&` instead of `&&`: no branch in the inner loop.
inline bool InNearField(const Law& law, const Ray<float>& ray, float depth) {
  return (depth > 0) & (ray.inverse_R2 > law.inverse_near2);
}

// Volumes of a column side by side, as many as two AVX2 registers hold.
constexpr int kLanes = 16;
struct Lanes {
  alignas(64) float value[kLanes];
};

// Sums the stress of all forces in the volumes at the heights z [m]; flags those in a near field.
SOFTSOIL_SIMD void SumForces(const Law& law, const ForceOnColumn* forces, int count, const Lanes& z,
                             Lanes* stress, Lanes* near) {
  Lanes sum{}, flag{};
  for (int i = 0; i < count; ++i) {
    const ForceOnColumn force = forces[i];
    // Not `omp simd`: gcc 12 keeps the branches then and makes no vectors, four times as slow.
    for (int lane = 0; lane < kLanes; ++lane) {
      const float depth = force.z - z.value[lane];
      const Ray<float> ray = RayTo(force.r2, depth);
      const float pair = FroehlichStress(law.nu, force.vertical, ray,
                                         CosinePower(law.cosine, ray.cosine_squared)) +
                         CerrutiStress(force.moment, ray);
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
    const double near = settings.near_field_radius;
    for (const double nu : settings.concentration_factors) {
      laws_.push_back(
          {static_cast<float>(nu), static_cast<float>(1 / (near * near)), FitCosinePower(nu)});
    }
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

  std::vector<Law> laws_;  // by soil
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
std::vector<ForceOnColumn> Reaching(const SurfaceLoad& load, const Law& law, double x, double y,
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
  const Law& law = laws_[batch.soil[column]];
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
