#include "plugin/cli/fit_tire_table.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "contact/flat_plate.h"
#include "terrain/input_error.h"

namespace softsoil {
namespace {

template <class... Values>
std::string Text(const char* format, Values... values) {
  char text[200];
  std::snprintf(text, sizeof text, format, values...);
  return text;
}

void PrintShape(const FittedTire& tire) {
  const TireShape& shape = tire.shape;
  if (std::isinf(shape.crown_radius)) {
    std::printf("cylinder: radius %g m, width %g m\n", shape.radius, shape.width);
    return;
  }
  std::printf("torus: radius %g m, width %g m, crown radius %.4g m", shape.radius, shape.width,
              shape.crown_radius);
  if (tire.crown) {
    std::printf(" +- %.2g m from contact widths, rms %.2g mm", tire.crown->confidence,
                1e3 * tire.crown->rms);
    if (std::isfinite(tire.crown->plateau)) {
      std::printf(", which grow to %.4g m and no more", tire.crown->plateau);
    }
  }
  std::printf("\n");
}

// "3.469e+05 +- 1.2 %" of each term.
std::string Terms(const SpringFit& fit) {
  std::string text;
  for (const auto term : fit.form->terms) {
    const double value = fit.spring.*term;
    const std::string cell =
        value > 0 ? Text("%.4g +- %.2g %%", value, 100 * fit.confidence.*term / value) : "0";
    text += Text("  %-20s", cell.c_str());
  }
  text.erase(text.find_last_not_of(' ') + 1);
  return text;
}

}  // namespace

std::string PressureOf(const PressureTest& test) {
  if (test.inflation_pressure <= 0) return "unknown pressure";
  return Shown(std::round(test.inflation_pressure) / 1e3) + " kPa";
}

void PrintFits(const FittedTire& tire) {
  PrintShape(tire);
  for (std::size_t t = 0; t < tire.tests.size(); ++t) {
    std::printf("\n%s, %zu rows\n", PressureOf(tire.tests[t]).c_str(),
                tire.tests[t].rows.load.size());
    std::printf("  %-14s  %9s  %9s  %8s  %-24s  p0, p1, p2 [SI]\n", "form", "rms [N]", "worst [N]",
                "R^2", "pressure [Pa]");
    for (std::size_t form = 0; form < tire.fits[t].size(); ++form) {
      const SpringFit& fit = tire.fits[t][form];
      std::printf("%s %-14s  %9.4g  %9.4g  %8.6f  %-24s%s\n", form == tire.best ? "*" : " ",
                  fit.form->name, fit.rms, fit.worst, fit.r_squared, fit.form->law,
                  Terms(fit).c_str());
    }
  }
  std::printf("\n* the best: the smallest error, the fewest terms among forms within 5 %% of it");
  if (tire.tests.size() > 1) std::printf(", the same terms at every pressure");
  std::printf("\n+- half width of the 95 %% interval; a term of 0 would be negative\n");
}

std::string FitsAsJson(const FittedTire& tire, const std::string& title) {
  constexpr int kPoints = 60;
  nlohmann::ordered_json json = {{"title", title}, {"tests", nlohmann::json::array()}};
  for (std::size_t t = 0; t < tire.tests.size(); ++t) {
    const LoadDeflection& rows = tire.tests[t].rows;
    nlohmann::ordered_json test = {{"name", PressureOf(tire.tests[t])},
                                   {"deflection", rows.deflection},
                                   {"load", rows.load},
                                   {"fits", nlohmann::json::array()}};
    for (std::size_t form = 0; form < tire.fits[t].size(); ++form) {
      const SpringFit& fit = tire.fits[t][form];
      std::vector<double> z, load;
      for (int i = 0; i <= kPoints; ++i) {
        z.push_back(rows.deflection.back() * i / kPoints);
        load.push_back(FlatPlateLoad(tire.shape, fit.spring, z.back()));
      }
      test["fits"].push_back({{"form", fit.form->name},
                              {"rms", fit.rms},
                              {"best", form == tire.best},
                              {"deflection", z},
                              {"load", load}});
    }
    json["tests"].push_back(test);
  }
  return json.dump(1);
}

}  // namespace softsoil
