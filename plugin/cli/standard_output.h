// What the program says is checked like any other output: `softsoil list > /dev/full` must fail.
#pragma once

namespace softsoil {

// Throws std::runtime_error if anything written to stdout was lost.
void FlushStandardOutput();

}  // namespace softsoil
