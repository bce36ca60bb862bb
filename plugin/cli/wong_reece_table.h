// What softsoil wong-reece writes and prints.
#pragma once

#include <string>
#include <vector>

#include "contact/wong_reece.h"

namespace softsoil {

struct WongReeceResults {
  std::string tire, soil;  // names in the catalogues
  RigidWheel wheel;
  SoilUnderRim under_rim;
  double load;                     // [N]
  std::vector<WongReece> rolling;  // towed where slip < 0
};

// wong_reece.csv: a row for each way of rolling. rim_stress.csv: rows along the rim for each.
// wong_reece.json: tire, soil and what was taken of both.
void WriteWongReece(const WongReeceResults& results, const std::string& folder);

void PrintWongReece(const WongReeceResults& results);

}  // namespace softsoil
