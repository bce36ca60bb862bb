// Least squares by the Levenberg-Marquardt algorithm of MINPACK, in Eigen's port, and how well the
// data determine the result.
#pragma once

#include <Eigen/Core>
#include <functional>

namespace softsoil {

struct Fit {
  Eigen::VectorXd parameters;
  Eigen::VectorXd residuals;       // at the parameters
  Eigen::VectorXd standard_error;  // of each parameter; infinite without a degree of freedom
  Eigen::VectorXd confidence;  // half width of the 95 % interval of each parameter (Student's t)
  double rms;                  // root of the mean squared residual
};

// Residuals, one per row, for given parameters.
using Residuals = std::function<Eigen::VectorXd(const Eigen::VectorXd& parameters)>;

// Parameters that minimise the sum of squared residuals near `start`; `size` > 0 is of the order of
// each. There are `rows` residuals.
// Standard errors are s sqrt(diag (J^T J)^-1), s^2 = sum r^2 / (rows - parameters) (Bates and Watts
// 1988, 2.3). Throws InputError if there are fewer rows than parameters, if the rows do not
// determine every parameter, or if the search does not converge.
Fit LeastSquares(const Residuals& residuals, const Eigen::VectorXd& start,
                 const Eigen::VectorXd& size, int rows);

}  // namespace softsoil
