// A soil: every parameter that the laws of this folder need.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "terrain/compaction.h"
#include "terrain/constants.h"
#include "terrain/plate_curve.h"
#include "terrain/shear.h"
#include "terrain/xml_catalogue.h"

namespace softsoil {

// Initial density from a depth downwards, to the top of the next layer.
struct DensityLayer {
  double top;      // [m]  below the undisturbed ground, > 0
  double density;  // [kg/m^3]  > 0
};

// Where on a rigid wheel the pressure is greatest, for the Wong-Reece method: theta_m = (c_1 + c_2
// i) theta_1. Madsen (2014) equation 2.19.
struct MaxStress {
  double c_1, c_2;  // [-]
};

struct Soil {
  std::string name, description;
  Bearing bearing;
  Unloading unloading;
  Shear shear;
  Compaction compaction;
  std::vector<DensityLayer> layers;  // from the top down; above the first: initial_density
  double concentration_factor;       // [-]  nu of Froehlich, 3 (elastic) to 6 (very soft)
  std::optional<MaxStress> max_stress;
  std::optional<double> angle_of_repose;  // [rad]  of a heap of loose soil, > 0
  double slip_sinkage = 0;                // [-]  S of SlipSinkage(), >= 0
};

constexpr double kMostSlipSinkage = 10;  // [-]  a share of the work; 1 is much

// Angle [rad] at which a heap of loose soil comes to rest: as given, or the friction angle, at
// which loose soil without cohesion stands (Terzaghi 1943), but no less than kLeastRepose.
double AngleOfRepose(const Soil& soil);
constexpr double kLeastRepose = 5 * kPi / 180;  // [rad]  clods of soil without friction still lock

// The highest heap [m] that an angle of repose must hold for.
constexpr double kHighestHeap = 1;

// Density [kg/m^3] of the undisturbed soil at a depth [m].
double InitialDensity(const Soil& soil, double depth);

// Weight [N/m^3] of undisturbed soil at the surface.
double UnitWeight(const Soil& soil);

// Density [kg/m^3] at which the virgin curve has 100 Pa, the least that the catalogue takes.
double LeastInitialDensity(const Compaction& soil);

// An empty catalogue for files such as models/soils/yolo_loam.xml.
Catalogue<Soil> SoilCatalogue();

// The numbers that every soil file has, in <bearing>, <shear>, <compaction>, <stress>. Those of
// <bearing> depend on its form, <bearing form="reece"> or by default bekker.
//
// A soil may have besides
//   <shear form="humped" residual="0.3">             a peak of the shear stress
//   <shear angle_of_repose_deg="30">                 of a heap of loose soil
//   <shear slip_sinkage="0.3">                       sinkage per way slipped and stress ratio
//   <unloading k_0="..." A_u="...">                  ground that springs back
//   <layers top="0.15 0.3" initial_density="1350 1500">
//   <moisture slope="..." saturation="..." reference_saturation="...">
//   <max_stress c_1="..." c_2="...">                 for the Wong-Reece method
const std::vector<Attribute<Soil>>& SoilAttributes(BearingForm form = BearingForm::kBekker);

}  // namespace softsoil
