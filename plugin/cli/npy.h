// Tables for numpy.
#pragma once

#include <string>
#include <vector>

namespace softsoil {

// Writes numbers row by row as a two-dimensional array of float32, in the .npy format 1.0.
// values.size() is a multiple of `columns`.
void WriteNpy(const std::string& path, const std::vector<float>& values, std::size_t columns);

}  // namespace softsoil
