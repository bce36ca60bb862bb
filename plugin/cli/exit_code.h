// What the program softsoil returns.
#pragma once

namespace softsoil {

enum ExitCode {
  kSuccess = 0,
  kFailed = 1,           // a run that began and could not be completed
  kBadInput = 2,         // refused before anything was done
  kNoSuchProgram = 127,  // softsoil with: as a shell says it
};

}  // namespace softsoil
