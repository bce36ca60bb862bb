// How the density of one soil volume follows the vertical stress on it.
// Madsen (2014) section 3.2.1 and algorithm 3.2.3.
#pragma once

#include <cmath>

#include "terrain/host_device.h"

namespace softsoil {

struct Compaction {
  double index;              // [kg/m^3 per decade of stress]  C, > 0
  double reference_density;  // [kg/m^3]  density on the virgin curve at reference_stress, > 0
  double reference_stress;   // [Pa]      > 0
  double initial_density;    // [kg/m^3]  > 0
  double rebound_index;      // [kg/m^3]  R: the most that a load cycle springs back, >= 0
  double compression_time;   // [s]       tau_c, > 0
  double rebound_time;       // [s]       tau_r, > 0
  double moisture_shift;     // [kg/m^3]  rho_S = S_T (S_1 - S_0)
};

// What a volume remembers. Its preconsolidation point is where the virgin curve starts for it.
struct SoilVolume {
  double density;                   // [kg/m^3]
  double preconsolidation_density;  // [kg/m^3]  rho_0
  double preconsolidation_stress;   // [Pa]      sigma_0
  double peak_density;              // [kg/m^3]  highest of this load cycle, 0 before it compacts
  double cycle_start_density;       // [kg/m^3]  is rho_0, but for the first cycle of Table 3.2
};

// How a load cycle hardens a volume, and from which stress it springs back.
//   kVirginCurve  to the point above its new density, sigma_0 10^((rho - rho_0)/C); it springs back
//                 below the preconsolidation stress.
//   kThesisTable  to sigma_0 10^(rho - rho_0) with rho in g/cm^3, for the division by C was left
//                 out in the program behind Table 3.2; it springs back as soon as it no longer
//                 compacts (line 8). Kept for comparison with that table alone.
enum class Hardening { kVirginCurve, kThesisTable };

// Stress [Pa] at which a volume of the given density [kg/m^3] lies on the virgin curve (3.5).
SOFTSOIL_HD inline double VirginStress(const Compaction& soil, double density) {
  const double decades = (density - soil.reference_density - soil.moisture_shift) / soil.index;
  return soil.reference_stress * std::pow(10.0, decades);
}

// Undisturbed volume of a density [kg/m^3]: on the virgin curve, so a looser soil yields earlier.
// The moisture shift moves the curve once; the thesis adds it anew in every load cycle
// (algorithm 3.2.3, line 1).
SOFTSOIL_HD inline SoilVolume UndisturbedVolume(const Compaction& soil, double density) {
  return {density, density, VirginStress(soil, density), 0, density};
}

SOFTSOIL_HD inline SoilVolume UndisturbedVolume(const Compaction& soil) {
  return UndisturbedVolume(soil, soil.initial_density);
}

SOFTSOIL_HD inline bool CycleIsOpen(const SoilVolume& volume) { return volume.peak_density > 0; }

// Density [kg/m^3] that the volume tends to under a stress [Pa] > 0, equation 3.4.
SOFTSOIL_HD inline double TargetDensity(const Compaction& soil, const SoilVolume& volume,
                                        double stress) {
  return volume.preconsolidation_density +
         soil.index * std::log10(stress / volume.preconsolidation_stress);
}

// Density [kg/m^3] to which the volume springs back: half the gain of the cycle, R at most.
// Algorithm 3.2.3 lines 11 to 15.
SOFTSOIL_HD inline double ReboundDensity(const Compaction& soil, const SoilVolume& volume) {
  const double half_gain = (volume.peak_density - volume.cycle_start_density) / 2;
  return volume.peak_density - (half_gain < soil.rebound_index ? half_gain : soil.rebound_index);
}

// The load is off: the preconsolidation point moves to the density reached. Lines 26 to 29.
SOFTSOIL_HD inline void EndCycle(const Compaction& soil, Hardening hardening, SoilVolume& volume) {
  const double gain = volume.density - volume.preconsolidation_density;
  const double decades = hardening == Hardening::kVirginCurve ? gain / soil.index : gain / 1000;
  volume.preconsolidation_stress *= std::pow(10.0, decades);
  volume.preconsolidation_density = volume.density;
  volume.cycle_start_density = volume.density;
  volume.peak_density = 0;
}

// Rebound [kg/m^3] that may still be due when the cycle of an unloaded volume is closed.
constexpr double kReboundDue = 1e-3;

// Whether a vertical stress [Pa] can change the volume.
SOFTSOIL_HD inline bool CanChange(const SoilVolume& volume, double stress) {
  return CycleIsOpen(volume) || stress > volume.preconsolidation_stress;
}

// Holds the vertical stress [Pa] (compression positive) on the volume for the time h [s].
//
// Above the preconsolidation stress it compacts towards the virgin curve (3.7); once the stress is
// below it after a compression, it springs back (3.8); when the load is off and the rebound is
// done, the load cycle ends. Both rates are written per elapsed time, so the result converges as
// h -> 0, even if the load goes in one step: the thesis' cumulative rebound clock (line 16) and its
// end of the cycle at the first instant without stress (line 26) do not.
SOFTSOIL_HD inline void Advance(const Compaction& soil, double stress, double h, SoilVolume& volume,
                                Hardening hardening = Hardening::kVirginCurve) {
  if (!CanChange(volume, stress)) return;
  const double target = stress > 0 ? TargetDensity(soil, volume, stress) : 0.0;
  const bool as_table = hardening == Hardening::kThesisTable;
  if (target > volume.density) {
    volume.density += (target - volume.density) * -std::expm1(-h / soil.compression_time);
    if (volume.density > volume.peak_density) volume.peak_density = volume.density;
  } else if (CycleIsOpen(volume) && (stress < volume.preconsolidation_stress || as_table)) {
    const double due = std::fmax(volume.density - ReboundDensity(soil, volume), 0.0);
    const double left = due * std::exp(-h / soil.rebound_time);
    volume.density -= due - left;
    if (stress <= 0 && (left < kReboundDue || as_table)) EndCycle(soil, hardening, volume);
  }
}

// Strain energy [J/m^3 of soil at density_before] of compacting at the stress [Pa]: sigma dz of
// equation 3.10 per height of the volume. Zero during rebound.
SOFTSOIL_HD inline double CompactionEnergy(double stress, double density_before,
                                           double density_after) {
  return density_after > density_before ? stress * (1 - density_before / density_after) : 0.0;
}

}  // namespace softsoil
