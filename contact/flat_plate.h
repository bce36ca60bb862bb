// The load-deflection test of a tire on a flat rigid plate. Section 4.2.
#pragma once

#include "contact/tire.h"

namespace softsoil {

// Load [N] that presses the tire the distance z [m] onto the plate, summed over the nodes that
// the contact uses, about `node_spacing` [m] apart.
double FlatPlateLoad(const Tire& tire, double z, double node_spacing);

// The same load [N] for nodes infinitely close, by adaptive quadrature to 1e-10 of it; z < r.
//
// With a = r - z the height of the axis and R the radius of the tire at the lateral distance y, the
// penetration is d = R - a / cos(theta) (4.30). A node of the area R dtheta dy / cos(beta) keeps
// the share (R - d) / R of it once loaded (section 4.3), and cos(theta) cos(beta) of its pressure
// is vertical (4.25), so that
//   F = 4 a int_0^y_max int_0^theta_max(y) p(R - a / cos(theta)) dtheta dy,  cos(theta_max) = a / R
// Equations 4.26 to 4.29 print the squares of the two cosines instead of the share of the area,
// r r_beta dtheta dbeta for the area itself and pi for the fourfold symmetry of the ellipse.
double FlatPlateLoad(const TireShape& shape, const TireSpring& spring, double z);

// Area [m^2] of the plate that the tire touches; z < r.
double FlatPlateArea(const TireShape& shape, double z);

// Greatest width [m] of a torus on the plate were it not cut off at its width: 2 r_beta
// sin(beta_max), cos(beta_max) = (r_beta - z) / r_beta. Equations 4.21 and 4.22.
double FlatPlateWidth(double crown_radius, double z);

}  // namespace softsoil
