#include "contact/tire_crown.h"

#include <algorithm>
#include <boost/math/distributions/fisher_f.hpp>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

#include "contact/flat_plate.h"
#include "terrain/input_error.h"
#include "terrain/least_squares.h"

namespace softsoil {
namespace {

using Eigen::VectorXd;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr std::size_t kLeastRising = 2, kLeastOnPlateau = 2;  // rows

struct Widths {
  std::vector<double> deflection, width;  // [m]  by rising deflection
};

Widths ByDeflection(const std::vector<double>& deflection, const std::vector<double>& width) {
  std::vector<std::size_t> order(deflection.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return deflection[a] < deflection[b]; });
  Widths rows;
  for (const std::size_t row : order) {
    rows.deflection.push_back(deflection[row]);
    rows.width.push_back(width[row]);
  }
  return rows;
}

// A fit and the number of rows below its plateau.
struct Trial {
  CrownFit fit;
  std::size_t rising;
  double squares;  // [m^2]  sum of squared errors
};

double Squares(const Widths& rows, double crown_radius, double plateau) {
  double sum = 0;
  for (std::size_t row = 0; row < rows.width.size(); ++row) {
    const double width = std::min(FlatPlateWidth(crown_radius, rows.deflection[row]), plateau);
    sum += (width - rows.width[row]) * (width - rows.width[row]);
  }
  return sum;
}

// The radius from the first `rising` rows, the plateau from the others.
Trial FitRising(const Widths& rows, std::size_t rising) {
  const std::size_t count = rows.width.size();
  VectorXd start = VectorXd::Zero(rising < count ? 2 : 1);
  for (std::size_t row = 0; row < count; ++row) {
    const double z = rows.deflection[row], w = rows.width[row];
    if (row < rising) {
      start[0] += (w * w / 4 / z + z) / 2 / static_cast<double>(rising);  // that fits one row
    } else {
      start[1] += w / static_cast<double>(count - rising);
    }
  }
  const auto residuals = [&](const VectorXd& x) {
    VectorXd r(count);
    for (std::size_t row = 0; row < count; ++row) {
      const double width = row < rising ? FlatPlateWidth(x[0], rows.deflection[row]) : x[1];
      r[static_cast<Eigen::Index>(row)] = width - rows.width[row];
    }
    return r;
  };
  const Fit fit = LeastSquares(residuals, start, start, static_cast<int>(count));
  const double plateau = rising < count ? fit.parameters[1] : kInfinity;
  const double squares = Squares(rows, fit.parameters[0], plateau);
  const double rms = std::sqrt(squares / static_cast<double>(count));
  return {{fit.parameters[0], fit.confidence[0], rms, plateau}, rising, squares};
}

// The best fit with a plateau, if there are rows enough.
std::optional<Trial> FitWithPlateau(const Widths& rows) {
  std::optional<Trial> best;
  for (std::size_t rising = 1; rising + kLeastOnPlateau <= rows.width.size(); ++rising) {
    const Trial trial = FitRising(rows, rising);
    if (!best || trial.squares < best->squares) best = trial;
  }
  return best;
}

// Whether two parameters leave so much less of the squared error than one that it is no chance.
bool IsBetter(double two, double one, std::size_t rows) {
  const double freedom = static_cast<double>(rows) - 2;
  const double ratio = boost::math::quantile(boost::math::fisher_f(1, freedom), 0.99);
  return one - two > ratio * two / freedom;
}

}  // namespace

CrownFit FitCrownRadius(const std::vector<double>& deflection, const std::vector<double>& width) {
  const Widths rows = ByDeflection(deflection, width);
  const std::size_t count = rows.width.size();
  const double mean = std::accumulate(width.begin(), width.end(), 0.0) / static_cast<double>(count);
  const double constant = Squares(rows, kInfinity, mean);

  const Trial round = FitRising(rows, count);
  const std::optional<Trial> capped = FitWithPlateau(rows);
  if (!capped || !IsBetter(capped->squares, round.squares, count)) {
    if (round.squares < constant) return round.fit;
  } else if (capped->rising >= kLeastRising && IsBetter(capped->squares, constant, count)) {
    return capped->fit;
  }
  throw InputError(
      "the contact widths do not tell the crown radius: they must rise with deflection, in at "
      "least "
      "two rows before the contact is as wide as the tread");
}

}  // namespace softsoil
