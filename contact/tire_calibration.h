// From loads on a flat plate to the spring of a tire, and to its damping. Section 4.2.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "contact/tire.h"

namespace softsoil {

// A form of spring: which terms it may have. Tables 6.1 to 6.3.
struct SpringForm {
  const char* name;
  const char* law;
  std::vector<double TireSpring::*> terms;
};
const std::array<SpringForm, 5>& SpringForms();

// Of one inflation pressure.
struct LoadDeflection {
  std::vector<double> deflection;  // [m]  z, >= 0 and < r
  std::vector<double> load;        // [N]  >= 0; 0 at z = 0
};

struct SpringFit {
  const SpringForm* form;
  TireSpring spring;      // terms that the data would have negative are zero
  TireSpring confidence;  // half width of the 95 % interval of each term; 0 of those left out
  double rms;             // [N]  root of the mean squared error of the load
  double worst;           // [N]  greatest error
  double r_squared;       // [-]  share of the loads' variance that the fit explains
  int terms;              // that are not zero
};

// The spring of a form with the least squared error of the loads of FlatPlateLoad (4.19), among
// those without negative terms: of every choice of the form's terms the unconstrained least squares
// fit is made, and of those that come out positive the best is taken. That is the constrained
// minimum, for there the terms that are not zero are unconstrained. Throws InputError if there are
// fewer rows than terms, or if the rows do not determine a spring.
//
// The rows determine the load: a dozen with noise of 2 % give it within 5 % from half the deepest
// deflection on, in every form. They hardly determine the terms of a form of several, whose loads
// run nearly parallel: from the same dozen the 95 % interval of the linear term of the 18.4R38's
// linear + root spring (Table 6.1) is half of its value to either side, and it takes thousands of
// rows to have each within 5 %. `confidence` tells.
SpringFit FitSpring(const SpringForm& form, const TireShape& shape, const LoadDeflection& test);

// All five, in the order of SpringForms().
std::vector<SpringFit> FitSprings(const TireShape& shape, const LoadDeflection& test);

// The form, by its place in SpringForms(), that fits a tire best: tests at one or several
// pressures, each with its fits by form. It is the form of the smallest error, the root of the mean
// of rms^2 over the tests; of forms that differ from it by less than 5 %, as much as a term without
// meaning gains over ten rows, or by less than 1e-6 of `largest_load` [N], the one with the fewest
// terms. Only forms with the same terms at every pressure can be interpolated and are admitted.
std::size_t BestForm(const std::vector<std::vector<SpringFit>>& fits_by_test, double largest_load);

// Whether the fits of a form have the same terms in every test.
bool HasTheSameTerms(const std::vector<std::vector<SpringFit>>& fits_by_test, std::size_t form);

// How a tire that is pressed onto a plate by `load` [N] swings.
struct PlateStiffness {
  double deflection;  // [m]
  double stiffness;   // [N/m]  radial
  double area;        // [m^2]  of contact
};
// Throws InputError if the tire does not carry the load at 0.9 of its radius.
PlateStiffness StiffnessUnder(double load, const TireShape& shape, const TireSpring& spring);

// Damping [Pa s/m] that gives the tire with the mass load / g on it the share `ratio` of critical
// damping: 2 ratio sqrt(k m) / A.
double EstimatedDamping(double ratio, double load, const PlateStiffness& stiffness);

}  // namespace softsoil
