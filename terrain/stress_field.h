// Vertical stress in the soil below loaded ground. One interface, several backends: `direct` is
// the reference that every other one is tested against.
#pragma once

#include <memory>
#include <vector>

#include "terrain/surface_load.h"

namespace softsoil {

// Columns whose stress is asked for. Volumes are counted from the top down.
struct ColumnBatch {
  int volumes;                           // per column
  std::vector<double> x, y;              // [m]  one per column
  std::vector<double> z;                 // [m]  centre of each volume, column by column
  std::vector<double> surface_pressure;  // [Pa]  vertical load on the column's own node
  std::vector<int> soil;                 // whose concentration factor counts

  std::size_t columns() const { return x.size(); }
};

// Which sum the stress is taken from.
enum class StressBackend { kDirect, kGaussian, kAuto };
constexpr StressBackend kStressBackends[] = {StressBackend::kDirect, StressBackend::kGaussian,
                                             StressBackend::kAuto};
const char* NameOf(StressBackend backend);  // direct, gaussian, auto

class StressField {
 public:
  virtual ~StressField() = default;

  // The backend that VerticalStress() of the same takes, never kAuto.
  virtual StressBackend BackendFor(const ColumnBatch& batch, const SurfaceLoad& load) const = 0;

  // Fills stress[column * batch.volumes + volume] [Pa], compression positive, resized to fit.
  // Volumes closer than the near field radius to a force take the surface pressure of their own
  // column (3.13): a lattice of point loads is right only some way below the surface.
  virtual void VerticalStress(const ColumnBatch& batch, const SurfaceLoad& load,
                              std::vector<float>* stress) const = 0;
};

struct StressSettings {
  std::vector<double> concentration_factors;  // [-]  nu, 3 to 6, by soil
  double near_field_radius;                   // [m]  R_min
  int threads;                                // at most, >= 1; no influence on results
};

// The sum over all pairs: columns in parallel, SIMD over the volumes of a column. In float; the
// error against the laws in double is below 1e-5 of the peak stress.
std::unique_ptr<StressField> MakeDirectStress(const StressSettings& settings);

// The same sum in parts: near pairs one by one, all others as Gaussians, which are separable, so
// that the cost of a pair falls with the number of pairs. Columns and forces must stand on the
// nodes of a grid of that spacing [m]. The near field is the same to the bit. The error against the
// sum over all pairs is below 1e-2 of the peak stress and 1e-3 in root mean square as long as
// horizontal forces are at most 0.8 of vertical ones.
std::unique_ptr<StressField> MakeGaussianStress(const StressSettings& settings, double spacing);

// Whichever of the two is faster for a batch and a load: from this number of pairs of a volume and
// a force on the Gaussians. A choice by size alone, so that results can be repeated.
constexpr double kPairsForGaussians = 1e5;
std::unique_ptr<StressField> MakeAutoStress(const StressSettings& settings, double spacing);

std::unique_ptr<StressField> MakeStressField(StressBackend backend, const StressSettings& settings,
                                             double spacing);

}  // namespace softsoil
