// A fuzz target is one file <name>_fuzz.cc that defines Read().
#pragma once

#include <string>

namespace softsoil {

// Hands the bytes of one input to a reader. May throw InputError; any other exception, a report of
// a sanitizer, a second of time or a gigabyte of memory is a finding.
void Read(const std::string& text);

}  // namespace softsoil
