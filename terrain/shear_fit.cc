#include "terrain/shear_fit.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "terrain/input_error.h"
#include "terrain/measurements.h"

namespace softsoil {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr std::size_t kLeastRows = 3;  // per normal stress
constexpr double kLeastApart = 0.05;   // [-]  normal stresses against the greatest shear stress

void RequireRisingSlip(const Measurements& table) {
  const std::vector<double>& j = table.Column("displacement");
  for (const auto& [stress, rows] : RowsByValue(table.Column("normal_stress"))) {
    const std::string test = "the test at normal stress " + Shown(stress) + " Pa";
    for (std::size_t i = 1; i < rows.size(); ++i) {
      if (j[rows[i]] > j[rows[i - 1]]) continue;
      table.Refuse(rows[i], "displacement of " + test + " must rise from row to row, got " +
                                Shown(j[rows[i]]) + " m after " + Shown(j[rows[i - 1]]) + " m");
    }
    if (rows.size() < kLeastRows) {
      table.Refuse(rows.back(), test + " must have at least " + std::to_string(kLeastRows) +
                                    " rows, got " + std::to_string(rows.size()));
    }
  }
}

// Peak of a test and the slip at which it has reached 63 % of it, which is K.
struct Peak {
  double stress, slip_at_63_percent, last_stress;
};

Peak PeakOf(const ShearTest& test, const std::vector<std::size_t>& rows) {
  Peak peak{0, 0, test.shear_stress[rows.back()]};
  for (std::size_t row : rows) peak.stress = std::max(peak.stress, test.shear_stress[row]);
  const auto first = std::find_if(rows.begin(), rows.end(), [&](std::size_t row) {
    return test.displacement[row] > 0 && test.shear_stress[row] >= 0.63 * peak.stress;
  });
  const std::size_t row = first != rows.end() ? *first : rows.back();
  peak.slip_at_63_percent = test.displacement[row];
  return peak;
}

// The unknowns: c / stress, tan(phi), K / slip, so that all are about one.
struct Model {
  VectorXd sigma, j, tau;
  double stress, slip;  // [Pa], [m]  units of the search

  VectorXd Residuals(double c, double tan_phi, double K) const {
    const Eigen::ArrayXd strength = c * stress + sigma.array() * tan_phi;
    const Eigen::ArrayXd mobilised = 1 - (-j.array() / (K * slip)).exp();
    return (strength * mobilised - tau.array()) / stress;
  }
};

VectorXd AsVector(const std::vector<double>& values) {
  return Eigen::Map<const VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

// Peaks on the line of Mohr-Coulomb and the mean slip.
Eigen::Vector3d Start(const ShearTest& test, Model* model) {
  const auto tests = RowsByValue(test.normal_stress);
  MatrixXd line(tests.size(), 2);
  VectorXd peaks(tests.size());
  model->slip = 0;
  Eigen::Index i = 0;
  for (const auto& [stress, rows] : tests) {
    const Peak peak = PeakOf(test, rows);
    line.row(i) << 1, stress / model->stress;
    peaks[i++] = peak.stress / model->stress;
    model->slip += peak.slip_at_63_percent / static_cast<double>(tests.size());
  }
  const VectorXd start = line.colPivHouseholderQr().solve(peaks);
  return {start[0], start[1], 1};
}

// Searches with all three unknowns, or without one that is held at zero.
Fit Search(const Model& model, const Eigen::Vector3d& start, StrengthBound bound) {
  const int rows = static_cast<int>(model.tau.size());
  if (bound == StrengthBound::kNone) {
    return LeastSquares([&](const VectorXd& u) { return model.Residuals(u[0], u[1], u[2]); }, start,
                        Eigen::Vector3d::Ones(), rows);
  }
  const bool no_cohesion = bound == StrengthBound::kNoCohesion;
  const double strength =
      model.tau.maxCoeff() / (no_cohesion ? model.sigma.maxCoeff() : model.stress);
  return LeastSquares(
      [&](const VectorXd& u) {
        return no_cohesion ? model.Residuals(0, u[0], u[1]) : model.Residuals(u[0], 0, u[1]);
      },
      Eigen::Vector2d(strength, start[2]), Eigen::Vector2d::Ones(), rows);
}

// From tan(phi) to phi; the error to first order.
Fitted AngleOf(const Fitted& tangent) {
  const double slope = 1 / (1 + tangent.value * tangent.value);
  return {std::atan(tangent.value), tangent.standard_error * slope, tangent.confidence * slope};
}

void Store(const Fit& fit, const Model& model, ShearFit* result) {
  const int last = static_cast<int>(fit.parameters.size()) - 1;
  const bool has_cohesion = result->bound != StrengthBound::kNoCohesion;
  const bool has_friction = result->bound != StrengthBound::kNoFriction;
  result->cohesion = has_cohesion ? FittedParameter(fit, 0, model.stress) : HeldAt(0);
  result->friction_angle = has_friction ? AngleOf(FittedParameter(fit, last - 1, 1)) : HeldAt(0);
  result->modulus = FittedParameter(fit, last, model.slip);
  result->rms = fit.rms * model.stress;
  const VectorXd fitted = model.tau + fit.residuals * model.stress;
  result->fitted.assign(fitted.begin(), fitted.end());
}

void RequireModulus(double modulus, double longest) {
  constexpr double kFarthest = 5;  // times the longest slip: there 18 % of the strength shows
  if (modulus > 0 && modulus <= kFarthest * longest) return;
  throw InputError("the readings ask for K = " + Rounded(modulus, 6) +
                   " m, which must be > 0 and at most 5 times the longest displacement, " +
                   Rounded(longest, 6) + " m: shear stress must rise and begin to level off");
}

void JudgeCurves(const ShearTest& test, ShearFit* result) {
  double longest = 0;
  for (double j : test.displacement) longest = std::max(longest, j);
  RequireModulus(result->modulus.value, longest);
  result->is_short = longest < 2 * result->modulus.value;
  for (const auto& [stress, rows] : RowsByValue(test.normal_stress)) {
    const Peak peak = PeakOf(test, rows);
    result->normal_stresses.push_back(stress);
    result->falls_after_peak |= peak.last_stress < 0.9 * peak.stress;
  }
}

}  // namespace

ShearTest ReadShearTest(const std::string& file) {
  const Measurements table(file,
                           {{"normal_stress", Quantity::kPressure},
                            {"displacement", Quantity::kLength},
                            {"shear_stress", Quantity::kPressure}},
                           kLeastRows);
  for (const char* column : {"normal_stress", "displacement", "shear_stress"}) {
    table.RequireNotNegative(column);
  }
  RequireRisingSlip(table);
  return {table.Column("normal_stress"), table.Column("displacement"),
          table.Column("shear_stress")};
}

ShearFit FitShear(const ShearTest& test) {
  const auto tests = RowsByValue(test.normal_stress);
  if (tests.size() == 1) {
    throw InputError("one normal stress, " + Shown(tests.begin()->first) +
                     " Pa, does not determine cohesion and friction angle; test a second one");
  }
  const double apart = tests.rbegin()->first - tests.begin()->first;
  const double strongest = *std::max_element(test.shear_stress.begin(), test.shear_stress.end());
  if (apart < kLeastApart * strongest) {
    throw InputError("the normal stresses must lie apart by at least " + Shown(kLeastApart) +
                     " of the greatest shear stress, " + Rounded(kLeastApart * strongest, 3) +
                     " Pa, to tell friction from cohesion, got " + Rounded(apart, 3) + " Pa");
  }
  Model model{AsVector(test.normal_stress), AsVector(test.displacement),
              AsVector(test.shear_stress), 0, 0};
  model.stress = model.tau.maxCoeff();
  if (model.stress <= 0) throw InputError("shear_stress must be > 0 Pa somewhere, got 0 Pa alone");
  const Eigen::Vector3d start = Start(test, &model);

  ShearFit result{};
  Fit fit = Search(model, start, StrengthBound::kNone);
  if (fit.parameters[0] < 0) {
    result.bound = StrengthBound::kNoCohesion;
    result.free_value = fit.parameters[0] * model.stress;
  } else if (fit.parameters[1] < 0) {
    result.bound = StrengthBound::kNoFriction;
    result.free_value = std::atan(fit.parameters[1]);
  }
  if (result.bound != StrengthBound::kNone) fit = Search(model, start, result.bound);
  Store(fit, model, &result);
  JudgeCurves(test, &result);
  return result;
}

}  // namespace softsoil
