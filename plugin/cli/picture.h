// Pictures of a run, drawn by the scripts in share/softsoil/plot.
#pragma once

#include <string>

namespace softsoil {

// A Python 3 that has matplotlib and numpy: the one found when softsoil was built, that of the
// system, or the first in PATH. Throws InputError if none has.
std::string PythonThatPlots();

// Draws <folder>/terrain.png and contact.png from the other files of the run. Throws
// std::runtime_error.
void DrawPictures(const std::string& python, const std::string& folder);

// Draws load-deflection data and the fits to them from the JSON file of softsoil fit-tire.
void DrawTireFit(const std::string& python, const std::string& json, const std::string& picture);

}  // namespace softsoil
