// The rigid wheel of Wong and Reece beside the tire: wong_reece.csv and wong_reece_rim.csv.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "contact/wong_reece.h"
#include "plugin/cli/drawbar.h"
#include "terrain/soil.h"

namespace softsoil {

struct RigidCurves {
  double radius = 0, speed = 0;                                 // [m], [m/s]
  std::vector<WongReece> curve;                                 // by rising slip
  std::vector<std::pair<double, std::vector<RimStress>>> rims;  // by SAE slip, as asked for
};

// A rigid wheel of the tire's unloaded radius and width, driven from a little slip to the largest
// of options.slips, and the stress on its rim at those that drive it. Throws InputError where the
// theory has no answer.
RigidCurves RigidCurvesOf(const TireShape& shape, const Soil& soil, const DrawbarOptions& options);

void WriteRigidCurves(const std::string& folder, const RigidCurves& curves);

}  // namespace softsoil
