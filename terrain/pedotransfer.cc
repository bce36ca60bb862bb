#include "terrain/pedotransfer.h"

#include <algorithm>
#include <cmath>

#include "terrain/input_error.h"

namespace softsoil {
namespace {

using C = const Composition&;

double Clay(C soil) { return soil.texture.clay; }
double Silt(C soil) { return soil.texture.silt; }
double Sand(C soil) { return soil.texture.sand; }
double ClayIndexOf(C soil) { return soil.clay_index; }
double GrainSizeIndexOf(C soil) { return soil.grain_size_index; }

RelationInput ClayFrom(double least, double most) { return {"clay", "%", Clay, {least, most}}; }
RelationInput SiltFrom(double least, double most) { return {"silt", "%", Silt, {least, most}}; }
RelationInput SandFrom(double least, double most) { return {"sand", "%", Sand, {least, most}}; }
RelationInput GrainSizeIndexFrom(double least, double most) {
  return {"grain size index", "", GrainSizeIndexOf, {least, most}};
}
// The indices of CH, ML, CL and MH.
std::vector<RelationInput> BothIndices() {
  return {{"clay index", "", ClayIndexOf, {0.93, 5}}, GrainSizeIndexFrom(2.32, 5)};
}

std::string WithUnit(double value, const char* unit) {
  return Shown(value) + (*unit != '\0' ? std::string(" ") + unit : "");
}

std::string RangesOf(const Relation& relation) {
  std::string ranges;
  for (const RelationInput& input : relation.inputs) {
    ranges += std::string(ranges.empty() ? "" : ", ") + input.name + " " +
              InWords(input.made_from) + (*input.unit != '\0' ? std::string(" ") + input.unit : "");
  }
  return ranges;
}

std::string WarningFor(const Relation& relation, C soil) {
  std::string warning = relation.caution;
  for (const RelationInput& input : relation.inputs) {
    const double value = std::round(input.of(soil) * 1e4) / 1e4;  // the digits that are printed
    if (Contains(input.made_from, value)) continue;
    warning += (warning.empty() ? "" : "; ") + std::string(input.name) + " " +
               WithUnit(value, input.unit) + " lies outside " + InWords(input.made_from);
  }
  return warning;
}

const Relation& Find(const std::string& result) {
  return *std::find_if(Relations().begin(), Relations().end(),
                       [&](const Relation& relation) { return relation.result == result; });
}

}  // namespace

const std::vector<Relation>& Relations() {
  static const std::vector<Relation> table = {
      {"clay index",
       "",
       false,
       "CH, ML, SW, CL, MH",
       {ClayFrom(6.9, 73.3)},
       [](C soil) { return ClayIndex(soil.texture); },
       ""},
      {"mean grain size",
       "m",
       false,
       "CH, ML, SW, CL, MH",
       {ClayFrom(6.9, 73.3), SiltFrom(2.3, 61.5), SandFrom(13.4, 90.8)},
       [](C soil) { return MeanGrainSize(soil.texture); },
       ""},
      {"grain size index",
       "",
       false,
       "CH, CL, MH",
       {{"mean grain size",
         "mm",
         [](C soil) { return MeanGrainSize(soil.texture) * 1e3; },
         {0.352, 0.76}}},
       [](C soil) { return GrainSizeIndex(MeanGrainSize(soil.texture)); },
       ""},
      {"compression index",
       "kg/m^3",
       false,
       "CH, ML, CL, MH",
       {ClayFrom(13.6, 73.3)},
       [](C soil) { return CompressionIndex(soil.texture.clay); },
       ""},
      {"reference density",
       "kg/m^3",
       false,
       "CH, ML, CL",
       {ClayFrom(13.6, 73.3)},
       [](C soil) { return DensityAt98kPa(soil.texture.clay); },
       ""},
      {"rebound index",
       "kg/m^3",
       true,
       "equation 3.9; used for CH, ML, CL, MH",
       {GrainSizeIndexFrom(2.32, 5)},
       [](C soil) { return ReboundIndex(soil.grain_size_index); },
       ""},
      {"moisture slope",
       "kg/m^3",
       false,
       "CH, ML",
       {SiltFrom(13.3, 61.5)},
       [](C soil) { return MoistureSlope(soil.texture.silt); },
       "a line through two soils, its unit read as per percent of saturation"},
      {"cohesion", "Pa", false, "CH, ML, CL, MH", BothIndices(),
       [](C soil) { return Cohesion(soil.clay_index, soil.grain_size_index); },
       "underdetermined: two soils with cohesion, three numbers"},
      {"friction angle", "deg", false, "CH, ML, CL, MH", BothIndices(),
       [](C soil) {
         return FrictionAngle(soil.clay_index, soil.grain_size_index, soil.cone_index) * kDegrees;
       },
       "four soils, four numbers: no check; rating cone index 80, but for CL and MH that of the "
       "thesis"},
      {"shear modulus", "m", false, "CH, ML, CL, MH", BothIndices(),
       [](C soil) { return ShearModulus(soil.clay_index, soil.grain_size_index); }, ""},
  };
  return table;
}

Estimate Apply(const std::string& result, const Composition& soil) {
  const Relation& relation = Find(result);
  if (result == "moisture slope" && IsCoarse(soil.texture)) {
    throw InputError("moisture slope: there are no data for coarse soils (sand > 50 %), got " +
                     Shown(soil.texture.sand) + " % sand; leave the saturation out");
  }
  return {relation.law(soil),
          relation.coefficients_are_printed ? "printed relation" : "fitted relation",
          std::string(relation.made_from) + "; " + RangesOf(relation), WarningFor(relation, soil)};
}

}  // namespace softsoil
