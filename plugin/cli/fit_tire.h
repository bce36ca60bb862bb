// softsoil fit-tire: from load-deflection data to an entry of the tire catalogue.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "contact/tire_crown.h"
#include "contact/tire_measurements.h"

namespace softsoil {

struct FitTireOptions {
  std::string data;                    // CSV file of loads
  std::string contact_width;           // CSV file; empty: none
  double radius = 0, width = 0;        // [m]
  std::optional<double> crown_radius;  // [m]
  bool cylinder = false;
  std::string spring;                       // name of the form to write; empty: the best
  std::string name;                         // of the entry, or of the family of entries
  std::optional<double> damping;            // [Pa s/m]
  std::optional<double> load;               // [N]  on the tire, to estimate the damping
  std::optional<double> friction;           // [-]  between tire and soil
  std::string like;                         // tire whose friction is taken
  std::vector<std::string> tire_files;      // catalogues besides the shipped one
  std::optional<std::string> out, picture;  // files
  bool no_picture = false;                  // none beside --out
  bool force = false;                       // overwrite these files
};

// What the data give.
struct FittedTire {
  TireShape shape;
  std::optional<CrownFit> crown;             // if fitted to contact widths
  std::vector<PressureTest> tests;           // by rising inflation pressure
  std::vector<std::vector<SpringFit>> fits;  // by test and form
  std::size_t best, chosen;                  // forms, by their place in SpringForms()
};

// Fits, prints the errors of each form, draws, writes the entries. Throws InputError before
// anything is written.
void FitTire(const FitTireOptions& options);

}  // namespace softsoil
