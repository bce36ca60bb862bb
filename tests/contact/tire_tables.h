// The springs that Madsen (2014) fitted, Tables 6.1 to 6.3, on the tires of 6.2.1 to 6.2.3. The
// section of a tire is its nominal width: 18.4 and 24.5 in.
#pragma once

#include <vector>

#include "contact/tire.h"

namespace softsoil {

struct PrintedSpring {
  TireSpring spring;
  double error;  // [-]  "Error * 10^3", without unit
};

struct PrintedTire {
  const char* name;
  TireShape shape;
  PrintedSpring linear, quadratic, linear_root, root, cubic;

  std::vector<PrintedSpring> All() const { return {linear, quadratic, linear_root, root, cubic}; }
};

// The cubic springs of Tables 6.2 and 6.3 have negative terms, as the thesis says.
inline const std::vector<PrintedTire>& PrintedTires() {
  static const std::vector<PrintedTire> tires = {{"18.4R38_85kPa",
                                                  {0.91, 0.661, 0.467},
                                                  {{1.314e6, 0, 0, 0}, 31.77},
                                                  {{7.433e5, 8.630e6, 0, 0}, 41.81},
                                                  {{2.289e5, 0, 0, 2.889e5}, 16.69},
                                                  {{0, 0, 0, 3.469e5}, 13.88},
                                                  {{6.991e5, 7.445e6, 7.290e6, 0}, 43.02}},
                                                 {"18.4R38_125kPa",
                                                  {0.91, 0.5582, 0.467},
                                                  {{2.121e6, 0, 0, 0}, 47.90},
                                                  {{1.683e6, 5.311e6, 0, 0}, 53.78},
                                                  {{6.859e5, 0, 0, 3.597e5}, 29.85},
                                                  {{0, 0, 0, 5.345e5}, 21.47},
                                                  {{4.619e6, -2.110e7, -1.709e8, 0}, 23.55}},
                                                 {"24.5R32_85kPa",
                                                  {0.91, 0.8606, 0.622},
                                                  {{1.269e6, 0, 0, 0}, 36.84},
                                                  {{1.237e6, 5.075e5, 0, 0}, 37.61},
                                                  {{4.830e5, 0, 0, 1.947e5}, 24.28},
                                                  {{0, 0, 0, 3.155e5}, 16.59},
                                                  {{1.439e6, 9.773e6, -1.619e8, 0}, 21.96}}};
  return tires;
}

}  // namespace softsoil
