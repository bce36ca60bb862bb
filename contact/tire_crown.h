// From contact widths on a flat plate to the crown radius of a tire. Section 4.2.2.
#pragma once

#include <vector>

namespace softsoil {

struct CrownFit {
  double crown_radius;  // [m]  r_beta
  double confidence;    // [m]  half width of the 95 % interval
  double rms;           // [m]  root of the mean squared error of the width
  double plateau;       // [m]  width that the contact does not exceed; infinity: none is seen
};

// The crown radius with the least squared error of the contact width [m] over the deflection [m]:
// equations 4.20 to 4.22, where 4.20 takes for the width what is half of it, y_max.
//
// A contact as wide as the tread grows no more, and the thesis assumes a greatest width (9.5 in).
// The law is therefore min(FlatPlateWidth, plateau), the plateau a second parameter if the rows
// show one: two of them at least, and with 99 % confidence (F test) a smaller error than without.
// It is the mean width of its rows and not the nominal width of the tread, which loaded tires
// exceed: an 18.4R38, 46.7 cm, was measured 53.5 cm wide (6.2.2).
//
// Throws InputError if the rows do not tell the radius: a constant width fits as well, or fewer
// than two rows lie below the plateau.
CrownFit FitCrownRadius(const std::vector<double>& deflection, const std::vector<double>& width);

}  // namespace softsoil
