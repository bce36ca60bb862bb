// The load of a torus on a flat plate after equations 4.21 to 4.30, integrated over the angles
// theta and beta of the tire by Gauss and Legendre's rule.
#pragma once

#include <functional>

struct PlateReading {
  double ellipse;        // factor of integrals B and C: pi as printed, 4 by symmetry
  bool exact_area;       // dA = r_beta (r - r_beta (1 - cos beta)), not r r_beta
  bool squared_cosines;  // of theta and beta, as 4.26 to 4.29 print; 4.25 has the cosines
  bool loaded_area;      // of section 4.3: dA shrinks with the radius as the tire is pressed in
};

// Radii and width [m], pressure [Pa] over penetration [m], deflection z [m].
double PlateLoadOracle(double r, double r_beta, double b,
                       const std::function<double(double)>& pressure, double z,
                       const PlateReading& reading);
