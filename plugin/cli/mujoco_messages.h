// What MuJoCo says in the middle of a call. Its own handlers write a log file into the current
// folder and wait for a key.
#pragma once

#include <string>
#include <vector>

namespace softsoil {

// From here on an error ends the program with exit code 1 and its message. A warning is printed
// when it comes first.
void HandleMujocoMessages();

// The warnings so far, in order, each once.
std::vector<std::string> MujocoWarnings();

}  // namespace softsoil
