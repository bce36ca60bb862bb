// The commands of the program softsoil. Each adds itself to the command line and runs when chosen.
#pragma once

#include <CLI/CLI.hpp>

namespace softsoil {

void AddRunCommand(CLI::App& program);
void AddDrawbarCommand(CLI::App& program);
void AddWongReeceCommand(CLI::App& program);
void AddListCommand(CLI::App& program);
void AddSoilCommand(CLI::App& program);
void AddWithCommand(CLI::App& program);
void AddFitTireCommand(CLI::App& program);

}  // namespace softsoil
