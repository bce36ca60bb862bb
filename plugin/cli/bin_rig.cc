#include "plugin/cli/bin_rig.h"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <string>

#include "terrain/input_error.h"

namespace softsoil {
namespace {

constexpr double kShortestSettling = 0.3, kLongestSettling = 5, kAtRest = 0.1;  // [s]
constexpr double kLoadError = 0.01;                                             // [-]

// How far [m] the rig must be lifted from its place above level ground at the height 0 for the
// lowest part of the wheel to touch the ground at one point.
double Lift(const TireShape& shape, const Simulation& rig) {
  const int steps = static_cast<int>(std::ceil(shape.radius / rig.Ground().grid_spacing));
  double lift = rig.Height(0, 0);
  for (int i = -steps; i <= steps; ++i) {
    const double x = shape.radius * i / steps;
    const double rise = shape.radius - std::sqrt(shape.radius * shape.radius - x * x);
    for (int j = -steps; j <= steps; ++j) {
      lift = std::max(lift, rig.Height(x, shape.width / 2 * j / steps) - rise);
    }
  }
  return lift;
}

// Height [m] of the undisturbed ground below the wheel. The deepest rut below the wheel is taken
// for the one below its centre.
double Undisturbed(const softsoilWheel& wheel, const Simulation& rig) {
  return rig.Height(wheel.centre[0], wheel.centre[1]) + wheel.rut_depth;
}

}  // namespace

std::unique_ptr<Simulation> MakeRig(const SoilBin& bin, int soil_threads) {
  static std::mutex one_at_a_time;  // as MuJoCo compiles models
  const std::lock_guard<std::mutex> lock(one_at_a_time);
  auto rig = std::make_unique<Simulation>("soil_bin.xml", SoilBinModel(bin));
  rig->GiveSoil("threads=" + std::to_string(soil_threads));
  rig->SetPosition(kHeave, Lift(bin.tire.shape, *rig));
  return rig;
}

bool Settle(double load, Simulation* rig) {
  double at_rest_since = 0;  // [s]
  while (rig->Time() < kLongestSettling) {
    StepUnlessSunk(load, rig);
    const double time = rig->Time(), carried = rig->Wheel(0).force[2];
    if (std::abs(carried - load) > kLoadError * load) at_rest_since = time;
    if (time > kShortestSettling && time - at_rest_since > kAtRest) return true;
  }
  return false;
}

bool SettleBraked(double load, Simulation* rig) {
  for (const char* joint : {kForward, kSpin}) rig->SetDamper(joint, kServoPerLoad * load);
  const bool settled = Settle(load, rig);
  for (const char* joint : {kForward, kSpin}) rig->SetDamper(joint, 0);
  return settled;
}

void StepUnlessSunk(double load, Simulation* rig) {
  rig->Step();
  const softsoilWheel wheel = rig->Wheel(0);
  if (wheel.centre[2] > Undisturbed(wheel, *rig)) return;
  throw InputError("--load: the soil cannot carry " + Shown(load) +
                   " N on this tire: the wheel sinks to its axle");
}

}  // namespace softsoil
