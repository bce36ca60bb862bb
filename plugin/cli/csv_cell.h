// One cell of a CSV file.
#pragma once

#include <string>

namespace softsoil {

std::string CsvCell(double value);  // nine digits
// A name from a model may hold anything: quoted where it holds a comma, a quote or a line break.
std::string CsvCell(const std::string& name);

}  // namespace softsoil
