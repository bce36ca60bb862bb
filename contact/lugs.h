// Lugs of a tread by parameters: bars from each edge of the tread to its middle, a herringbone.
#pragma once

#include "terrain/xml_catalogue.h"

namespace softsoil {

// Straight bars of one height. The outer radius of the tire is over the lugs. Driving forward, the
// end of a lug in the middle of the tread comes to the ground first.
struct Lugs {
  double height = 0;      // [m]    above the carcass between them, > 0; 0: no lugs
  int count = 0;          // [-]    around the tire, of each half of the tread, >= 1
  double angle = 0;       // [rad]  from straight across, 0 to below pi/2; the halves are mirrored
  double void_share = 0;  // [-]    of the tread that is not lug, between 0 and 1
  double stagger = 0;     // [-]    of the left half against the right, as a share of the pitch
  explicit operator bool() const { return height > 0; }
};
bool operator==(const Lugs& a, const Lugs& b);

// Angle [rad] around the wheel by which a lug is ahead of, or behind, its place at angle 0. At y
// [m] left of the middle of a tire of the outer radius [m].
double LugLead(const Lugs& lugs, double radius, double y);

// Whether there is a lug at the angle theta [rad], ahead of the lowest point in the tire frame.
bool IsLug(const Lugs& lugs, double radius, double theta, double y);

// Width [m] of a lug, across its length.
double LugWidth(const Lugs& lugs, double radius);

// Free distance [m] between two lugs along the circumference.
double LugGap(const Lugs& lugs, double radius);

// Reads <lugs height="..." angle_deg="..." stagger="..."> and two of width, void_share and one of
// pitch or count, or all three if they agree. The pitch becomes a whole part of the circumference.
// `radius` and `least_radius` [m]: outer radius of the tire at the middle and the edge of the
// tread.
Lugs ReadLugs(XmlEntry& entry, double radius, double least_radius);

// Stress [Pa] across, on the sides of a strip of the width b [m] that bears the pressure p [Pa],
// down to the depth h [m]: (p / pi) arccot(h / b), after Bekker (1956).
double SideStress(double pressure, double height, double width);

}  // namespace softsoil
