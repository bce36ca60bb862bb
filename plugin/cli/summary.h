// What a run comes to, for programs and for people.
#pragma once

#include "plugin/cli/run.h"

namespace softsoil {

// <folder>/summary.json
void WriteSummary(const RunOptions& options, const RunResult& result);

// A table of the wheels and where the files are, on standard output.
void PrintSummary(const RunOptions& options, const RunResult& result);

}  // namespace softsoil
