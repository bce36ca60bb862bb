#include "terrain/stress_field.h"

namespace softsoil {
namespace {

class AutoStress : public StressField {
 public:
  AutoStress(const StressSettings& settings, double spacing)
      : direct_(MakeDirectStress(settings)), gaussian_(MakeGaussianStress(settings, spacing)) {}

  StressBackend BackendFor(const ColumnBatch& batch, const SurfaceLoad& load) const override {
    const double volumes = static_cast<double>(batch.z.size());
    const double pairs = volumes * static_cast<double>(load.size());
    return pairs < kPairsForGaussians ? StressBackend::kDirect : StressBackend::kGaussian;
  }

  void VerticalStress(const ColumnBatch& batch, const SurfaceLoad& load,
                      std::vector<float>* stress) const override {
    const bool is_direct = BackendFor(batch, load) == StressBackend::kDirect;
    (is_direct ? *direct_ : *gaussian_).VerticalStress(batch, load, stress);
  }

 private:
  std::unique_ptr<StressField> direct_, gaussian_;
};

}  // namespace

const char* NameOf(StressBackend backend) {
  switch (backend) {
    case StressBackend::kDirect: return "direct";
    case StressBackend::kGaussian: return "gaussian";
    default: return "auto";
  }
}

std::unique_ptr<StressField> MakeAutoStress(const StressSettings& settings, double spacing) {
  return std::make_unique<AutoStress>(settings, spacing);
}

std::unique_ptr<StressField> MakeStressField(StressBackend backend, const StressSettings& settings,
                                             double spacing) {
  switch (backend) {
    case StressBackend::kDirect: return MakeDirectStress(settings);
    case StressBackend::kGaussian: return MakeGaussianStress(settings, spacing);
    default: return MakeAutoStress(settings, spacing);
  }
}

}  // namespace softsoil
