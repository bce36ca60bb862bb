#include "contact/tire_calibration.h"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>

#include "contact/flat_plate.h"
#include "terrain/constants.h"
#include "terrain/input_error.h"
#include "terrain/least_squares.h"

namespace softsoil {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

// Loads [N] by row and term of a spring whose only term is 1: the load is linear in the terms.
MatrixXd LoadsOfTerms(const SpringForm& form, const TireShape& shape,
                      const std::vector<double>& deflection) {
  MatrixXd loads(deflection.size(), form.terms.size());
  for (Eigen::Index k = 0; k < loads.cols(); ++k) {
    TireSpring unit;
    unit.*form.terms[k] = 1;
    for (Eigen::Index row = 0; row < loads.rows(); ++row) {
      loads(row, k) = FlatPlateLoad(shape, unit, deflection[row]);
    }
  }
  return loads;
}

// The terms among those of a form that a trial leaves free.
std::vector<Eigen::Index> Chosen(unsigned trial, Eigen::Index count) {
  std::vector<Eigen::Index> chosen;
  for (Eigen::Index k = 0; k < count; ++k) {
    if ((trial >> k & 1U) != 0) chosen.push_back(k);
  }
  return chosen;
}

// Least squares with the chosen terms alone, each in the share of the largest load that it carries
// there: all are then of one size.
struct Trial {
  std::vector<Eigen::Index> chosen;
  VectorXd unit;  // [Pa/m^k] of each share
  Fit fit;        // of the shares; residuals in shares of the largest load
};

Trial FitChosen(const MatrixXd& loads, const VectorXd& measured, std::vector<Eigen::Index> chosen) {
  const double largest = measured.maxCoeff();
  const auto count = static_cast<Eigen::Index>(chosen.size());
  Trial trial{std::move(chosen), VectorXd(count), {}};
  MatrixXd shares(loads.rows(), count);
  for (Eigen::Index k = 0; k < count; ++k) {
    const auto column = loads.col(trial.chosen[k]);
    trial.unit[k] = largest / column.maxCoeff();
    shares.col(k) = column / column.maxCoeff();
  }
  const VectorXd target = measured / largest;
  const auto residuals = [&](const VectorXd& x) -> VectorXd { return shares * x - target; };
  trial.fit = LeastSquares(residuals, VectorXd::Constant(count, 1.0 / static_cast<double>(count)),
                           VectorXd::Ones(count), static_cast<int>(loads.rows()));
  return trial;
}

SpringFit Result(const SpringForm& form, const Trial& trial, const VectorXd& measured) {
  const double largest = measured.maxCoeff();
  SpringFit result{&form, {}, {}, 0, 0, 0, static_cast<int>(trial.chosen.size())};
  for (std::size_t k = 0; k < trial.chosen.size(); ++k) {
    const auto i = static_cast<Eigen::Index>(k);
    result.spring.*form.terms[trial.chosen[k]] = trial.fit.parameters[i] * trial.unit[i];
    result.confidence.*form.terms[trial.chosen[k]] = trial.fit.confidence[i] * trial.unit[i];
  }
  const VectorXd errors = trial.fit.residuals * largest;
  const double variance = (measured.array() - measured.mean()).square().sum();
  result.rms = trial.fit.rms * largest;
  result.worst = errors.cwiseAbs().maxCoeff();
  result.r_squared = 1 - errors.squaredNorm() / variance;
  return result;
}

}  // namespace

const std::array<SpringForm, 5>& SpringForms() {
  using S = TireSpring;
  static const std::array<SpringForm, 5> forms = {{
      {"linear", "p0 d", {&S::linear}},
      {"quadratic", "p0 d + p1 d^2", {&S::linear, &S::quadratic}},
      {"linear + root", "p0 d + p1 sqrt(d)", {&S::linear, &S::root}},
      {"root", "p0 sqrt(d)", {&S::root}},
      {"cubic", "p0 d + p1 d^2 + p2 d^3", {&S::linear, &S::quadratic, &S::cubic}},
  }};
  return forms;
}

SpringFit FitSpring(const SpringForm& form, const TireShape& shape, const LoadDeflection& test) {
  if (test.load.size() < form.terms.size()) {
    throw InputError("the spring form " + std::string(form.name) + " needs at least " +
                     std::to_string(form.terms.size()) + " rows, got " +
                     std::to_string(test.load.size()));
  }
  const MatrixXd loads = LoadsOfTerms(form, shape, test.deflection);
  const VectorXd measured = VectorXd::Map(test.load.data(), loads.rows());
  std::optional<Trial> best;
  for (unsigned choice = 1; choice < 1U << form.terms.size(); ++choice) {
    Trial trial = FitChosen(loads, measured, Chosen(choice, loads.cols()));
    if (trial.fit.parameters.minCoeff() <= 0) continue;
    if (!best || trial.fit.rms < best->fit.rms) best = std::move(trial);
  }
  return Result(form, *best, measured);  // a single term that carries a load is positive
}

std::vector<SpringFit> FitSprings(const TireShape& shape, const LoadDeflection& test) {
  std::vector<SpringFit> fits;
  for (const SpringForm& form : SpringForms()) fits.push_back(FitSpring(form, shape, test));
  return fits;
}

bool HasTheSameTerms(const std::vector<std::vector<SpringFit>>& fits_by_test, std::size_t form) {
  for (const auto term : SpringForms()[form].terms) {
    for (const std::vector<SpringFit>& fits : fits_by_test) {
      const bool has = fits[form].spring.*term > 0, first = fits_by_test[0][form].spring.*term > 0;
      if (has != first) return false;
    }
  }
  return true;
}

std::size_t BestForm(const std::vector<std::vector<SpringFit>>& fits_by_test, double largest_load) {
  constexpr double kEqual = 0.05, kExact = 1e-6;
  std::array<double, 5> error{};
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t form = 0; form < error.size(); ++form) {
    for (const std::vector<SpringFit>& fits : fits_by_test) {
      error[form] += fits[form].rms * fits[form].rms / static_cast<double>(fits_by_test.size());
    }
    error[form] = std::sqrt(error[form]);
    if (HasTheSameTerms(fits_by_test, form)) least = std::min(least, error[form]);
  }
  const double bound = std::max(least * (1 + kEqual), least + kExact * largest_load);
  // A form that has lost a term is the same spring as one that never had it.
  const auto simplicity = [&](std::size_t form) {
    const SpringFit& fit = fits_by_test[0][form];
    return std::make_tuple(fit.terms, fit.form->terms.size(), error[form]);
  };
  std::size_t best = error.size();
  for (std::size_t form = 0; form < error.size(); ++form) {
    if (error[form] > bound || !HasTheSameTerms(fits_by_test, form)) continue;
    if (best == error.size() || simplicity(form) < simplicity(best)) best = form;
  }
  return best;
}

PlateStiffness StiffnessUnder(double load, const TireShape& shape, const TireSpring& spring) {
  const auto excess = [&](double z) { return FlatPlateLoad(shape, spring, z) - load; };
  const double deepest = 0.9 * shape.radius;
  if (excess(deepest) < 0) {
    throw InputError("the tire does not carry " + Shown(load) + " N at 0.9 of its radius");
  }
  std::uintmax_t most = 100;
  const auto bracket = boost::math::tools::toms748_solve(
      excess, 0.0, deepest, boost::math::tools::eps_tolerance<double>(40), most);
  const double z = (bracket.first + bracket.second) / 2, h = 1e-3 * z;
  const double stiffness = (excess(z + h) - excess(z - h)) / (2 * h);
  return {z, stiffness, FlatPlateArea(shape, z)};
}

double EstimatedDamping(double ratio, double load, const PlateStiffness& stiffness) {
  return 2 * ratio * std::sqrt(stiffness.stiffness * load / kGravity) / stiffness.area;
}

}  // namespace softsoil
