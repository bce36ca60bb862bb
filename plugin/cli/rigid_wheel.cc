#include "plugin/cli/rigid_wheel.h"

#include <algorithm>

#include "plugin/cli/csv_cell.h"
#include "plugin/cli/output_file.h"
#include "terrain/constants.h"
#include "terrain/input_error.h"

namespace softsoil {
namespace {

constexpr int kCurvePoints = 60, kRimPoints = 61;
constexpr double kDegrees = 180 / kPi;

// One line of a CSV file.
std::string Row(const std::vector<double>& values) {
  std::string row;
  for (const double value : values) row += (row.empty() ? "" : ",") + CsvCell(value);
  return row + "\n";
}

}  // namespace

RigidCurves RigidCurvesOf(const TireShape& shape, const Soil& soil, const DrawbarOptions& options) {
  return At("--wong-reece", [&] {
    const RigidWheel wheel = {shape.radius, shape.width};
    const SoilUnderRim under = {BearingModulus(soil.bearing, shape.width), soil.bearing.n,
                                soil.shear, *options.wong_reece};
    RigidCurves curves;
    curves.radius = shape.radius;
    curves.speed = options.speed;
    const double last = *std::max_element(options.slips.begin(), options.slips.end());
    for (int k = 1; k <= kCurvePoints && last > 0; ++k) {
      const double slip = last * k / kCurvePoints;
      curves.curve.push_back(DrivenWheel(wheel, under, options.load, SlipFromSae(slip)));
    }
    for (const double slip : options.slips) {
      if (slip < 0) continue;
      const WongReece rolling = DrivenWheel(wheel, under, options.load, SlipFromSae(slip));
      curves.rims.emplace_back(slip, StressAlongRim(wheel, under, rolling, kRimPoints));
    }
    return curves;
  });
}

void WriteRigidCurves(const std::string& folder, const RigidCurves& curves) {
  OutputFile file(folder + "/wong_reece.csv");
  file.Write(
      "slip [-],thrust [N],motion_resistance [N],drawbar_pull [N],torque [N m],power [W],"
      "sinkage [m],entry_angle [deg],max_stress_angle [deg]\n");
  for (const WongReece& w : curves.curve) {
    const double slip = SaeFromSlip(w.slip);
    file.Write(Row({slip, w.thrust, w.motion_resistance, w.drawbar_pull, w.torque,
                    w.torque * (1 + slip) * curves.speed / curves.radius, w.sinkage,
                    w.entry_angle * kDegrees, w.max_stress_angle * kDegrees}));
  }
  file.Finish();

  OutputFile rim(folder + "/wong_reece_rim.csv");
  rim.Write("slip [-],angle [deg],pressure [Pa],shear [Pa]\n");
  for (const auto& [slip, stresses] : curves.rims) {
    for (const RimStress& s : stresses) {
      rim.Write(Row({slip, s.angle * kDegrees, s.pressure, s.shear}));
    }
  }
  rim.Finish();
}

}  // namespace softsoil
