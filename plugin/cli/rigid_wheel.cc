#include "plugin/cli/rigid_wheel.h"

#include "terrain/input_error.h"

namespace softsoil {
namespace {

SoilUnderRim UnderRim(const Soil& soil, double width, const DrawbarOptions& options) {
  SoilUnderRim under = {BearingModulus(soil.bearing, width), soil.bearing.n, soil.shear, {}};
  if (options.c_1) {
    under.max_stress = {*options.c_1, *options.c_2};
  } else if (soil.max_stress) {
    under.max_stress = {soil.max_stress->c_1, soil.max_stress->c_2};
  } else {
    throw InputError("soil \"" + soil.name + "\" has no <max_stress c_1=... c_2=...>, where it " +
                     "presses most on a driven wheel; give --c1 and --c2");
  }
  return under;
}

}  // namespace

WongReeceResults RigidWheelBeside(const Tire& tire, const Soil& soil,
                                  const DrawbarOptions& options) {
  const RigidWheel wheel = {tire.shape.radius, tire.shape.width};
  WongReeceResults results = {tire.name,    soil.name, wheel, UnderRim(soil, wheel.width, options),
                              options.load, {}};
  for (const double slip : options.slips) {
    if (slip < 0) continue;
    results.rolling.push_back(At("--wong-reece: slip " + Shown(slip), [&] {
      return DrivenWheel(wheel, results.under_rim, options.load, SlipFromSae(slip));
    }));
  }
  return results;
}

}  // namespace softsoil
