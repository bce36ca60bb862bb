// What the library tells the person who runs it: lines on stderr that begin with "softsoil: ".
#pragma once

#include <string>

namespace softsoil {

// Each distinct text is said once per process: the model compiler steps a mjData of its own, and
// several threads may simulate the same model.
void Say(const std::string& message);

}  // namespace softsoil
