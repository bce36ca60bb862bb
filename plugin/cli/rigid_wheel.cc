#include "plugin/cli/rigid_wheel.h"

#include <algorithm>

#include "terrain/input_error.h"

namespace softsoil {

std::optional<MaxStress> MaxStressGiven(std::optional<double> c_1, std::optional<double> c_2) {
  if (c_1.has_value() != c_2.has_value()) {
    throw InputError("--c1 and --c2 must be given together");
  }
  if (!c_1) return {};
  return MaxStress{*c_1, *c_2};
}

SoilUnderRim UnderRim(const Soil& soil, double width, const std::optional<MaxStress>& max_stress) {
  SoilUnderRim under = {BearingModulus(soil.bearing, width), soil.bearing.n, soil.shear, {}};
  if (max_stress) {
    under.max_stress = *max_stress;
  } else if (soil.max_stress) {
    under.max_stress = *soil.max_stress;
  } else {
    throw InputError("soil \"" + soil.name + "\" has no <max_stress c_1=... c_2=...>, where it " +
                     "presses most on a driven wheel; give --c1 and --c2");
  }
  return under;
}

WongReeceResults RigidWheelBeside(const Tire& tire, const Soil& soil,
                                  const DrawbarOptions& options) {
  const RigidWheel wheel = {tire.shape.radius, options.rigid_width.value_or(tire.shape.width)};
  const SoilUnderRim under = UnderRim(soil, wheel.width, options.max_stress);
  WongReeceResults results = {tire.name, soil.name, wheel, under, options.load, {}};
  for (const double slip : options.slips) {
    if (slip < 0) continue;
    results.rolling.push_back(At("--wong-reece: slip " + Shown(slip), [&] {
      return DrivenWheel(wheel, under, options.load, SlipFromSae(slip));
    }));
  }
  if (results.rolling.empty()) {
    throw InputError("--wong-reece: the rigid wheel is driven, so one --slip must be >= 0, got " +
                     Shown(*std::max_element(options.slips.begin(), options.slips.end())));
  }
  return results;
}

}  // namespace softsoil
