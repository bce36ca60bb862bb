// One cell of a CSV file.
#pragma once

#include <optional>
#include <string>

namespace softsoil {

std::string CsvCell(double value);                        // nine digits
std::string CsvCell(const std::optional<double>& value);  // empty if there is none
// A name from a model may hold anything: quoted where it holds a comma, a quote or a line break.
std::string CsvCell(const std::string& name);

}  // namespace softsoil
