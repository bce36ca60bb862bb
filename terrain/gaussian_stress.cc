#include <algorithm>
#include <climits>
#include <map>
#include <memory>

#include "terrain/far_stress.h"
#include "terrain/near_stress.h"
#include "terrain/stress_field.h"
#include "terrain/worker_pool.h"

namespace softsoil {
namespace {

// Calls work(part, index) for the indices 0 to count(part) - 1 of every part, on all threads.
template <class Count, class Work>
void ForEachOfParts(int parts, int threads, const Count& count, const Work& work) {
  struct Task {
    int part, index;
  };
  std::vector<Task> tasks;
  for (int part = 0; part < parts; ++part) {
    for (int index = 0; index < count(part); ++index) tasks.push_back({part, index});
  }
  WorkerPool::Shared().ForEach(static_cast<int>(tasks.size()), threads,
                               [&](int task) { work(tasks[task].part, tasks[task].index); });
}

// In order of the nodes' j and then i.
SurfaceLoad ByRows(SurfaceLoad load) {
  std::stable_sort(load.begin(), load.end(), [](const NodeForce& a, const NodeForce& b) {
    return a.node.j != b.node.j ? a.node.j < b.node.j : a.node.i < b.node.i;
  });
  return load;
}

class GaussianStress : public StressField {
 public:
  GaussianStress(const StressSettings& settings, double spacing)
      : spacing_(spacing), threads_(settings.threads) {
    std::map<double, int> known;
    for (const double nu : settings.concentration_factors) {
      const auto [law, is_new] = known.emplace(nu, static_cast<int>(laws_.size()));
      law_of_soil_.push_back(law->second);
      if (!is_new) continue;
      laws_.push_back({FarLaw(nu), NearLaw(nu, settings.near_field_radius, spacing)});
    }
  }

  StressBackend BackendFor(const ColumnBatch&, const SurfaceLoad&) const override {
    return StressBackend::kGaussian;
  }

  void VerticalStress(const ColumnBatch& batch, const SurfaceLoad& load,
                      std::vector<float>* stress) const override {
    stress->assign(batch.columns() * batch.volumes, 0.0f);
    const SurfaceLoad rows = ByRows(load);
    const std::vector<StressPatch> patches = MakePatches(batch, law_of_soil_, spacing_);
    const std::vector<FarStress> far = Far(patches, rows);
    ForEachOfParts(
        static_cast<int>(patches.size()), threads_, [&](int part) { return patches[part].nx; },
        [&](int part, int ix) {
          NearStress near(batch, patches[part], ix);
          near.Add(laws_[patches[part].law].near, rows);
          Combine(batch, near, far[part], ix, stress);
        });
  }

 private:
  struct Law {
    FarLaw far;
    NearLaw near;
  };

  std::vector<FarStress> Far(const std::vector<StressPatch>& patches,
                             const SurfaceLoad& rows) const;
  static void Combine(const ColumnBatch& batch, const NearStress& near, const FarStress& far,
                      int ix, std::vector<float>* stress);

  std::vector<Law> laws_;
  std::vector<int> law_of_soil_;
  double spacing_;
  int threads_;
};

std::vector<FarStress> GaussianStress::Far(const std::vector<StressPatch>& patches,
                                           const SurfaceLoad& rows) const {
  std::vector<FarStress> far;
  int first = INT_MAX, last = INT_MIN, farthest = 0;
  for (const StressPatch& patch : patches) {
    far.emplace_back(patch, laws_[patch.law].far, rows, spacing_);
    if (far.back().planes() == 0) continue;
    first = std::min(first, far.back().first_bell());
    last = std::max(last, far.back().last_bell());
    farthest = std::max(farthest, far.back().farthest());
  }
  if (first > last) return far;
  const Bells bells(first, last, farthest);
  ForEachOfParts(
      static_cast<int>(far.size()), threads_, [&](int part) { return far[part].planes(); },
      [&](int part, int plane) { far[part].WorkOut(plane, bells); });
  return far;
}

// For the columns of one line of a patch.
void GaussianStress::Combine(const ColumnBatch& batch, const NearStress& near, const FarStress& far,
                             int ix, std::vector<float>* stress) {
  const StressPatch& patch = far.patch();
  const std::vector<float> on_planes = far.OnPlanes(ix);
  for (int iy = 0; iy < patch.ny; ++iy) {
    const int column = patch.column[std::size_t(ix) * patch.ny + iy];
    if (column < 0) continue;
    const std::size_t first = std::size_t(column) * batch.volumes;
    float* out = &(*stress)[first];
    if (!on_planes.empty()) {
      far.AddBetween(&on_planes[iy * far.planes()], &batch.z[first], batch.volumes, out);
    }
    const float own = static_cast<float>(batch.surface_pressure[column]);
    for (int k = 0; k < batch.volumes; ++k) {
      out[k] = near.IsInNearField(iy, k) ? own : out[k] + near.Stress(iy, k);
    }
  }
}

}  // namespace

std::unique_ptr<StressField> MakeGaussianStress(const StressSettings& settings, double spacing) {
  return std::make_unique<GaussianStress>(settings, spacing);
}

}  // namespace softsoil
