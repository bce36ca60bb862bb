// A mark in mjData that names the state of the soil that belongs to it.
//
// It stands in the last two numbers of userdata, so that whatever copies or restores a mjData takes
// it along, and mj_resetData clears it.
#pragma once

#include <mujoco/mujoco.h>

#include <cmath>

namespace softsoil {

constexpr int kMarkSize = 2;                        // numbers of userdata
constexpr double kLeastHistory = 4503599627370496;  // 2^52: not what others keep in userdata

// Both zero: undisturbed soil. Otherwise whole numbers.
struct RevisionMark {
  double history = 0;   // which history holds it; never the same in two processes
  double revision = 0;  // from 1

  bool IsUndisturbed() const { return history == 0 && revision == 0; }
  // Whether it can be the mark of a state at all.
  bool IsPossible() const {
    return history >= kLeastHistory && history == std::floor(history) && revision >= 1 &&
           revision == std::floor(revision);
  }
  bool operator==(const RevisionMark& other) const {
    return history == other.history && revision == other.revision;
  }
  bool operator!=(const RevisionMark& other) const { return !(*this == other); }
};

// nuserdata: of the model.
inline bool HasRoomForMark(int nuserdata) { return nuserdata >= kMarkSize; }

// With room for a mark.
inline RevisionMark MarkIn(int nuserdata, const mjData* d) {
  const mjtNum* mark = d->userdata + nuserdata - kMarkSize;
  return {mark[0], mark[1]};
}

inline void PutMark(RevisionMark mark, int nuserdata, mjData* d) {
  mjtNum* place = d->userdata + nuserdata - kMarkSize;
  place[0] = mark.history;
  place[1] = mark.revision;
}

}  // namespace softsoil
