// Our share of a row of xfrc_applied, beside what the host applies to the same body.
//
// Some hosts clear the rows before every step, others never do, and mjv_applyPerturbForce writes
// over a row. A component that reads as we left it was not touched: the host's part of it is what
// it was. One that reads otherwise was written by the host, and what it reads is the host's part.
// Nothing is ever subtracted, so nothing drifts. Two things cannot be told apart and count as the
// host's part until it clears the row: what a host adds to a row it has not cleared takes our share
// along, and so does a row that mj_copyData brings from another mjData whose soil is not copied.
#pragma once

#include <array>
#include <optional>

#include "terrain/state_stream.h"

namespace softsoil {

using WrenchRow = std::array<double, 6>;  // [N], [N m]  force, torque about the centre of mass

class OwnShare {
 public:
  // Puts `share` into the row in place of what was there of us.
  void Write(const WrenchRow& share, double* row) {
    Recognise(row);
    for (int k = 0; k < 6; ++k) {
      if (row[k] != known_.left[k]) known_.hosts[k] = row[k];
      row[k] = known_.left[k] = known_.hosts[k] + share[k];
    }
    other_.reset();
  }

  // Takes our share out of the row.
  void Remove(double* row) { Write(WrenchRow{}, row); }

  // Until the next Write() the row may come from another mjData: where it reads as `other` left it,
  // what `other` knows of the host's part holds.
  void Expect(const OwnShare& other) { other_ = other.known_; }

  // Holds the row against what is known of it.
  void Recognise(const double* row) {
    if (!other_) return;
    for (int k = 0; k < 6; ++k) {
      if (row[k] != other_->left[k]) continue;
      known_.left[k] = other_->left[k];
      known_.hosts[k] = other_->hosts[k];
    }
  }

  bool operator==(const OwnShare& other) const {
    return known_.left == other.known_.left && known_.hosts == other.known_.hosts;
  }

  void Write(StateWriter& writer) const {
    writer.PutBytes(known_.left.data(), sizeof known_.left);
    writer.PutBytes(known_.hosts.data(), sizeof known_.hosts);
  }
  void Read(StateReader& reader) {  // throws InputError
    reader.GetFinite(known_.left.data(), known_.left.size());
    reader.GetFinite(known_.hosts.data(), known_.hosts.size());
  }

 private:
  struct Row {
    WrenchRow left{};   // the row as we left it
    WrenchRow hosts{};  // the host's part of it
  };
  Row known_;
  std::optional<Row> other_;  // how it may read besides
};

}  // namespace softsoil
