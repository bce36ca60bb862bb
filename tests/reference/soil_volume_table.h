// Madsen (2014), Table 3.2: a volume of USCS CL soil (Table 3.1: C 0.5133 g/cm^3) under three load
// cycles to 350 kPa at six vehicle speeds, as printed.
#pragma once

namespace softsoil_reference {

struct SoilVolumeRow {
  double speed;          // [m/s]
  double density_gain;   // [g/cm^3]
  double energy;         // [kJ/m^3]
  double power;          // [kW/m^3]  peak
  double final_density;  // [g/cm^3]
  double final_stress;   // [kPa]     preconsolidation stress in the end
};

constexpr SoilVolumeRow kSoilVolumeTable[] = {
    {0.5, 0.2508, 71.66, 197.92, 1.517, 201.3}, {1, 0.1652, 53.17, 235.9, 1.431, 165.3},
    {2, 0.08797, 33.76, 271.5, 1.354, 138.4},   {3, 0.05432, 24.70, 293.4, 1.321, 128.1},
    {4, 0.05099, 19.26, 305.5, 1.317, 127.1},   {5, 0.04556, 15.82, 313.3, 1.311, 125.5},
};

}  // namespace softsoil_reference
