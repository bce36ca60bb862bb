// Half-sine load cycles on one soil volume, as a wheel passing over it makes them.
#pragma once

#include <algorithm>
#include <cmath>

#include "terrain/compaction.h"

namespace softsoil {

struct LoadCycle {
  double peak;      // [Pa]
  double duration;  // [s]
  double step;      // [s]
};

struct CycleWork {
  double energy = 0;      // [J/m^3]
  double peak_power = 0;  // [W/m^3]
};

// One cycle, after which the stress is zero until the volume has sprung back.
inline void ApplyCycle(const Compaction& soil, const LoadCycle& cycle, SoilVolume& volume,
                       CycleWork* work = nullptr, Hardening hardening = Hardening::kVirginCurve) {
  const int steps = static_cast<int>(cycle.duration / cycle.step);
  for (int i = 1; i <= steps; ++i) {
    const double stress = cycle.peak * std::sin(std::acos(-1.0) * i * cycle.step / cycle.duration);
    const double before = volume.density;
    Advance(soil, stress, cycle.step, volume, hardening);
    if (work == nullptr) continue;
    const double energy = CompactionEnergy(stress, before, volume.density);
    work->energy += energy;
    work->peak_power = std::max(work->peak_power, energy / cycle.step);
  }
  while (CycleIsOpen(volume)) Advance(soil, 0, cycle.step, volume, hardening);
}

}  // namespace softsoil
