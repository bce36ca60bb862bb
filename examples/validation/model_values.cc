// Values of softsoil's own laws for the validation, one line of numbers per call:
//   model_values flat_plate RADIUS CROWN_RADIUS WIDTH LINEAR QUADRATIC CUBIC ROOT DEFLECTION
//     load [N] of a tire on a rigid plate; all in SI, CROWN_RADIUS inf for a cylinder
//   model_values soil_volume SPEED INITIAL DENSITY STRESS INDEX REBOUND
//     density gain [kg/m^3], energy [J/m^3], peak power [W/m^3], density [kg/m^3] and
//     preconsolidation stress [Pa] in the end of a volume under three half-sine load cycles to
//     350 kPa, hardening as in Table 3.2 of Madsen (2014); from INITIAL on, with the virgin curve
//     through DENSITY at STRESS
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <vector>

#include "contact/flat_plate.h"
#include "terrain/load_cycle.h"

namespace softsoil {
namespace {

// Identified from Table 3.2, as the thesis prints none of them: the length over which a wheel
// presses on a place, and the two times.
constexpr double kFootprint = 0.1891;        // [m]
constexpr double kCompressionTime = 0.2016;  // [s]
constexpr double kReboundTime = 0.0042;      // [s]

void PrintFlatPlate(const std::vector<double>& v) {
  const TireShape shape{v[0], v[1], v[2]};
  const TireSpring spring{v[3], v[4], v[5], v[6]};
  std::printf("%.10g\n", FlatPlateLoad(shape, spring, v[7]));
}

void PrintSoilVolume(const std::vector<double>& v) {
  Compaction soil{};
  soil.index = v[4];
  soil.rebound_index = v[5];
  soil.compression_time = kCompressionTime;
  soil.rebound_time = kReboundTime;
  SoilVolume volume{v[1], v[2], v[3], 0, v[1]};
  CycleWork work;
  for (int cycle = 0; cycle < 3; ++cycle) {
    ApplyCycle(soil, {350e3, kFootprint / v[0], 1e-3}, volume, &work, Hardening::kThesisTable);
  }
  std::printf("%.10g %.10g %.10g %.10g %.10g\n", volume.density - v[1], work.energy,
              work.peak_power, volume.density, volume.preconsolidation_stress);
}

int Main(int argc, char** argv) {
  const std::vector<double> numbers = [&] {
    std::vector<double> parsed;
    for (int i = 2; i < argc; ++i) parsed.push_back(std::strtod(argv[i], nullptr));
    return parsed;
  }();
  if (argc == 10 && std::strcmp(argv[1], "flat_plate") == 0) {
    PrintFlatPlate(numbers);
  } else if (argc == 8 && std::strcmp(argv[1], "soil_volume") == 0) {
    PrintSoilVolume(numbers);
  } else {
    std::fprintf(stderr, "model_values: see its first lines for what it takes\n");
    return 2;
  }
  return 0;
}

}  // namespace
}  // namespace softsoil

int main(int argc, char** argv) { return softsoil::Main(argc, argv); }
