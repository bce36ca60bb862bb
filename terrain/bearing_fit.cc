#include "terrain/bearing_fit.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "terrain/input_error.h"
#include "terrain/measurements.h"

namespace softsoil {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr std::size_t kLeastRows = 3;  // per width
constexpr double kLeastWider = 1.1;    // [-]  the widest plate against the narrowest

std::string Plate(double width) { return "the plate of width " + Shown(width) + " m"; }

void RequireRisingLoad(const Measurements& table, double width,
                       const std::vector<std::size_t>& rows) {
  constexpr double kNoise = 0.1;  // of the largest pressure
  const std::vector<double>&z = table.Column("sinkage"), &p = table.Column("pressure");
  double largest = 0;
  for (std::size_t row : rows) largest = std::max(largest, p[row]);
  double reached = p[rows[0]];
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const std::size_t row = rows[i], before = rows[i - 1];
    if (z[row] <= z[before]) {
      table.Refuse(row, "sinkage of " + Plate(width) + " must rise from row to row, got " +
                            Shown(z[row]) + " m after " + Shown(z[before]) + " m");
    }
    if (p[row] < reached - kNoise * largest) {
      table.Refuse(row, "pressure must not fall while " + Plate(width) + " sinks, got " +
                            Shown(p[row]) + " Pa after " + Shown(reached) + " Pa");
    }
    reached = std::max(reached, p[row]);
  }
}

void RequireRows(const Measurements& table, double width, const std::vector<std::size_t>& rows) {
  const std::vector<double>&z = table.Column("sinkage"), &p = table.Column("pressure");
  const auto pressed = static_cast<std::size_t>(std::count_if(
      rows.begin(), rows.end(), [&](std::size_t row) { return z[row] > 0 && p[row] > 0; }));
  if (pressed >= kLeastRows) return;
  table.Refuse(rows.back(), Plate(width) + " must have at least " + std::to_string(kLeastRows) +
                                " rows with sinkage and pressure, got " + std::to_string(pressed));
}

void RequireZeroedGauge(const Measurements& table) {
  const std::vector<double>&z = table.Column("sinkage"), &p = table.Column("pressure");
  for (std::size_t row = 0; row < table.rows(); ++row) {
    if (z[row] > 0 || p[row] == 0) continue;
    table.Refuse(row, "pressure must be 0 Pa where the sinkage is 0, got " + Shown(p[row]) + " Pa");
  }
}

// The law as p = factors x s^n with s the sinkage, over the width in the form of Reece.
struct PowerLaw {
  MatrixXd factors;  // by row and modulus
  VectorXd s, p;
};

PowerLaw LawOf(const PlateSinkage& test, BearingForm form) {
  std::vector<std::size_t> rows;
  for (std::size_t row = 0; row < test.sinkage.size(); ++row) {
    if (test.sinkage[row] > 0) rows.push_back(row);
  }
  const auto count = static_cast<Eigen::Index>(rows.size());
  PowerLaw law{MatrixXd(count, 2), VectorXd(count), VectorXd(count)};
  for (Eigen::Index i = 0; i < count; ++i) {
    const double b = test.width[rows[i]], z = test.sinkage[rows[i]];
    const bool reece = form == BearingForm::kReece;
    law.factors.row(i) << (reece ? 1 : 1 / b), (reece ? b : 1);
    law.s[i] = reece ? z / b : z;
    law.p[i] = test.pressure[rows[i]];
  }
  return law;
}

// The exponent by Wong's (1980) weighted least squares: one slope of ln p over ln s for all plates,
// an intercept for each, weight p^2.
double StartExponent(const PlateSinkage& test) {
  double covariance = 0, variance = 0;
  for (const auto& [width, rows] : RowsByValue(test.width)) {
    double weight = 0, x_sum = 0, y_sum = 0, xx = 0, xy = 0;
    for (std::size_t row : rows) {
      const double z = test.sinkage[row], p = test.pressure[row];
      if (z <= 0 || p <= 0) continue;
      const double w = p * p, x = std::log(z), y = std::log(p);
      weight += w;
      x_sum += w * x;
      y_sum += w * y;
      xx += w * x * x;
      xy += w * x * y;
    }
    if (weight <= 0) throw InputError(Plate(width) + " must bear some pressure, got 0 Pa");
    covariance += xy - x_sum * y_sum / weight;
    variance += xx - x_sum * x_sum / weight;
  }
  return covariance / variance;
}

// A fit in units of its own.
struct ScaledFit {
  Fit fit;
  VectorXd scale;   // of the parameters
  double pressure;  // [Pa]  of the residuals
};

// Moduli and exponent; in units of `scale` and of the largest pressure, so that steps of the search
// and of its derivatives suit all of them.
ScaledFit FitPowerLaw(const PowerLaw& law, double n_start) {
  const double largest = law.p.maxCoeff();
  const auto moduli = law.factors.cols();
  const MatrixXd at_start = law.s.array().pow(n_start).matrix().asDiagonal() * law.factors;
  VectorXd scale = VectorXd::Ones(moduli + 1);
  scale.head(moduli) = largest * at_start.colwise().maxCoeff().cwiseInverse().transpose();

  VectorXd start(moduli + 1);
  start << at_start.colPivHouseholderQr().solve(law.p).cwiseQuotient(scale.head(moduli)), n_start;
  const auto residuals = [&](const VectorXd& u) -> VectorXd {
    const VectorXd modulus = law.factors * u.head(moduli).cwiseProduct(scale.head(moduli));
    return (modulus.array() * law.s.array().pow(u[moduli]) - law.p.array()) / largest;
  };
  return {
      LeastSquares(residuals, start, VectorXd::Ones(moduli + 1), static_cast<int>(law.p.size())),
      scale, largest};
}

// The moduli that were searched for, and then the exponent, are the parameters.
void Store(const ScaledFit& scaled, BearingFit* result) {
  const int last = static_cast<int>(scaled.scale.size()) - 1;
  const auto parameter = [&](int i) { return FittedParameter(scaled.fit, i, scaled.scale[i]); };
  const bool both = last == 2, no_frictional = result->basis == ModuliFrom::kNoFrictional;
  result->cohesive = both || no_frictional ? parameter(0) : HeldAt(0);
  result->frictional = no_frictional ? HeldAt(0) : parameter(last - 1);
  result->exponent = parameter(last);
  result->rms = scaled.fit.rms * scaled.pressure;
}

// What a fit with both moduli leaves of them. The form of Bekker needs k_phi.
void HoldAtZero(BearingFit* result) {
  if (result->cohesive.value < 0) {
    result->basis = ModuliFrom::kNoCohesive;
    result->free_value = result->cohesive.value;
  } else if (result->frictional.value < 0 && result->form == BearingForm::kReece) {
    result->basis = ModuliFrom::kNoFrictional;
    result->free_value = result->frictional.value;
  }
}

void RequirePositive(const char* name, double value) {
  if (value > 0) return;
  throw InputError(std::string("the readings ask for ") + name + " = " + Rounded(value, 6) +
                   ", which must be > 0");
}

double PressureOf(const BearingFit& fit, double b, double z) {
  const Bearing bearing{fit.cohesive.value, fit.frictional.value, fit.exponent.value, fit.form};
  return BearingPressure(BearingModulus(bearing, b), bearing.n, z);
}

}  // namespace

PlateSinkage ReadPlateSinkage(const std::string& file) {
  const Measurements table(file,
                           {{"width", Quantity::kLength},
                            {"sinkage", Quantity::kLength},
                            {"pressure", Quantity::kPressure}},
                           kLeastRows);
  table.RequirePositive("width");
  table.RequireNotNegative("sinkage");
  table.RequireNotNegative("pressure");
  RequireZeroedGauge(table);
  for (const auto& [width, rows] : RowsByValue(table.Column("width"))) {
    RequireRisingLoad(table, width, rows);
    RequireRows(table, width, rows);
  }
  return {table.Column("width"), table.Column("sinkage"), table.Column("pressure")};
}

BearingFit FitBearing(const PlateSinkage& test, BearingForm form) {
  BearingFit result{};
  result.form = form;
  for (const auto& plate : RowsByValue(test.width)) result.widths.push_back(plate.first);
  const bool one_width = result.widths.size() == 1;
  if (!one_width && result.widths.back() < kLeastWider * result.widths.front()) {
    throw InputError("the widest plate must be at least " + Shown(kLeastWider) +
                     " times as wide as the narrowest to tell the moduli apart, got " +
                     Shown(result.widths.front()) + " and " + Shown(result.widths.back()) + " m");
  }
  if (one_width && form == BearingForm::kReece) {
    throw InputError("one plate width, " + Shown(test.width[0]) +
                     " m, does not determine k_1 and k_2; test a second one");
  }
  PowerLaw law = LawOf(test, form);
  const double n_start = StartExponent(test);
  if (one_width) {
    result.basis = ModuliFrom::kPlatesOfOneWidth;
  } else {
    Store(FitPowerLaw(law, n_start), &result);
    HoldAtZero(&result);
  }
  if (result.basis != ModuliFrom::kPlates) {
    const int kept = result.basis == ModuliFrom::kNoFrictional ? 0 : 1;
    law.factors = MatrixXd(law.factors.col(kept));
    Store(FitPowerLaw(law, n_start), &result);
  }
  if (form == BearingForm::kBekker) RequirePositive("k_phi", result.frictional.value);
  RequirePositive("n", result.exponent.value);
  for (std::size_t row = 0; row < test.width.size(); ++row) {
    result.fitted.push_back(PressureOf(result, test.width[row], test.sinkage[row]));
  }
  return result;
}

}  // namespace softsoil
