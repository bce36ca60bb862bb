// Rows of nodes across the tread.
#pragma once

#include <vector>

#include "contact/wheel_contact.h"

namespace softsoil {

// The contacts of one row, as indices: [first, end), and the outermost nodes of the tread, -1 where
// that edge is in the air.
struct TreadRow {
  int first, end;
  int right = -1, left = -1;
};

template <class Visit>
void ForEachRow(const std::vector<NodeContact>& contacts, int rings, const Visit& visit) {
  const int count = static_cast<int>(contacts.size());
  for (int i = 0; i < count;) {
    const int number = contacts[i].node / rings;
    TreadRow row{i, i};
    for (; i < count && contacts[i].node / rings == number; row.end = ++i) {
      if (contacts[i].node % rings == 0) row.right = i;
      if (contacts[i].node % rings == rings - 1) row.left = i;
    }
    visit(row);
  }
}

}  // namespace softsoil
