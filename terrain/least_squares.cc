#include "terrain/least_squares.h"

#include <Eigen/LU>
#include <Eigen/QR>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <limits>
#include <unsupported/Eigen/NonLinearOptimization>
#include <unsupported/Eigen/NumericalDiff>

#include "terrain/input_error.h"

namespace softsoil {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

// The derivative of Eigen steps by a part of the variable, so no variable may come near zero, as a
// parameter often does. Hence the search is for y = parameter / size + kShift.
constexpr double kShift = 2;

VectorXd Parameters(const VectorXd& y, const VectorXd& size) {
  return size.cwiseProduct((y.array() - kShift).matrix());
}

// What Eigen asks of a function to minimise.
struct Problem {
  using Scalar = double;
  using InputType = VectorXd;
  using ValueType = VectorXd;
  using JacobianType = MatrixXd;
  enum { InputsAtCompileTime = Eigen::Dynamic, ValuesAtCompileTime = Eigen::Dynamic };

  int inputs() const { return parameters; }
  int values() const { return rows; }
  int operator()(const VectorXd& y, VectorXd& r) const {
    r = residuals(Parameters(y, size));
    return r.allFinite() ? 0 : -1;  // negative: stop
  }

  const Residuals& residuals;
  VectorXd size;
  int parameters, rows;
};
using Differentiated = Eigen::NumericalDiff<Problem, Eigen::Central>;

// (J^T J)^-1 with columns brought to length one first, as the parameters differ in size.
MatrixXd InverseNormalMatrix(const MatrixXd& jacobian) {
  constexpr double kLeastRank = 1e-10;  // [-]  smallest against largest pivot
  const VectorXd lengths = jacobian.colwise().norm();
  if (lengths.minCoeff() > 0) {
    const VectorXd scale = lengths.cwiseInverse();
    const MatrixXd scaled = jacobian * scale.asDiagonal();
    Eigen::ColPivHouseholderQR<MatrixXd> qr(scaled);
    qr.setThreshold(kLeastRank);
    if (qr.rank() == jacobian.cols()) {
      const MatrixXd inverse = (scaled.transpose() * scaled).inverse();
      return scale.asDiagonal() * inverse * scale.asDiagonal();
    }
  }
  throw InputError("the measurements do not determine all " + std::to_string(jacobian.cols()) +
                   " parameters");
}

void JudgeFit(const MatrixXd& jacobian, Fit* fit) {
  const MatrixXd inverse = InverseNormalMatrix(jacobian);
  const auto freedom = jacobian.rows() - jacobian.cols();
  if (freedom == 0) {
    fit->standard_error =
        VectorXd::Constant(jacobian.cols(), std::numeric_limits<double>::infinity());
    fit->confidence = fit->standard_error;
    return;
  }
  const double variance = fit->residuals.squaredNorm() / static_cast<double>(freedom);
  fit->standard_error = (variance * inverse.diagonal()).cwiseSqrt();
  const boost::math::students_t distribution(static_cast<double>(freedom));
  fit->confidence = boost::math::quantile(distribution, 0.975) * fit->standard_error;
}

}  // namespace

Fit LeastSquares(const Residuals& residuals, const VectorXd& start, const VectorXd& size,
                 int rows) {
  const int count = static_cast<int>(start.size());
  if (rows < count) {
    throw InputError("there must be at least as many rows as parameters, " + std::to_string(count) +
                     ", got " + std::to_string(rows));
  }
  Differentiated problem{Problem{residuals, size, count, rows}};
  Eigen::LevenbergMarquardt<Differentiated> search(problem);
  search.parameters.ftol = search.parameters.xtol = 1e-14;
  search.parameters.maxfev = 2000 * (count + 1);

  VectorXd y = (start.array() / size.array() + kShift).matrix();
  const auto status = search.minimize(y);
  using namespace Eigen::LevenbergMarquardtSpace;
  if (status == UserAsked || status == ImproperInputParameters ||
      status == TooManyFunctionEvaluation) {
    throw InputError("the least squares search does not converge");
  }
  Fit fit;
  fit.parameters = Parameters(y, size);
  fit.residuals = residuals(fit.parameters);
  fit.rms = std::sqrt(fit.residuals.squaredNorm() / rows);
  MatrixXd jacobian(rows, count);
  problem.df(y, jacobian);
  JudgeFit(jacobian * size.cwiseInverse().asDiagonal(), &fit);
  return fit;
}

}  // namespace softsoil
