// Pictures of a run, drawn by the scripts in share/softsoil/plot.
#pragma once

#include <string>
#include <vector>

namespace softsoil {

// A Python 3 that has matplotlib and numpy: the one found when softsoil was built, that of the
// system, or the first in PATH. Throws InputError if none has.
std::string PythonThatPlots();

// Draws <folder>/<name>.png by plot/<name>.py from the other files in the folder, for each name.
// Throws std::runtime_error.
void DrawPictures(const std::string& python, const std::string& folder,
                  const std::vector<std::string>& names);

// Runs share/softsoil/plot/<script> with these arguments, to draw `picture`. Throws
// std::runtime_error.
void Draw(const std::string& python, const std::string& script,
          const std::vector<std::string>& arguments, const std::string& picture);

}  // namespace softsoil
