// Several numbers in one option of the command line.
#pragma once

#include <string>
#include <vector>

namespace softsoil {

constexpr int kMostNumbers = 10000;  // in one option

// The numbers of a text such as "0.2", "0.05,0.1,0.3", "0.1:0.7:0.1" (first, last, step) or a mix,
// in the order given. A range holds its last number if steps lead there; its numbers are rounded
// to 12 digits, as one would write them: 0.3, not 0.30000000000000004. Throws InputError that
// begins with `name`, the option.
std::vector<double> NumbersIn(const std::string& name, const std::string& text);

}  // namespace softsoil
