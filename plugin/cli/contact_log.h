// contact.csv: one row per tire node that touches the ground, at the instants chosen.
#pragma once

#include <string>
#include <vector>

#include "plugin/softsoil.h"
#include "terrain/output_file.h"

namespace softsoil {

class ContactLog {
 public:
  // Writes the names of the columns with their units.
  explicit ContactLog(const std::string& path);
  // time [s] of simulation. A wheel in the air has no contacts and gets no row.
  void Write(double time, const softsoilWheel& wheel, const std::vector<softsoilContact>& contacts);
  void Finish() { file_.Finish(); }

 private:
  OutputFile file_;
};

}  // namespace softsoil
