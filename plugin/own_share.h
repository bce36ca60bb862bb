// Our share of a row of xfrc_applied, beside what the host applies to the same body.
//
// Some hosts clear the rows before every step, others never do, and mjv_applyPerturbForce writes
// over a row. A component that reads as we left it was not touched: the host's part of it is what
// it was. One that reads otherwise was written by the host, and what it reads is the host's part.
// Nothing is ever subtracted, so nothing drifts. Two things cannot be told apart and count as the
// host's part until it clears the row: what a host adds to a row it has not cleared takes our share
// along, and so does a row that mj_copyData brings from another mjData with soil.
#pragma once

#include <array>

namespace softsoil {

using WrenchRow = std::array<double, 6>;  // [N], [N m]  force, torque about the centre of mass

class OwnShare {
 public:
  // Puts `share` into the row in place of what was there of us.
  void Write(const WrenchRow& share, double* row) {
    for (int k = 0; k < 6; ++k) {
      if (row[k] != left_[k]) hosts_[k] = row[k];
      row[k] = left_[k] = hosts_[k] + share[k];
    }
  }

  // Takes our share out of the row.
  void Remove(double* row) { Write(WrenchRow{}, row); }

 private:
  WrenchRow left_{};   // the row as we left it
  WrenchRow hosts_{};  // the host's part of it
};

}  // namespace softsoil
