#include "plugin/cli/npy.h"

#include "terrain/output_file.h"

namespace softsoil {
namespace {

// Magic, version, length of the description in two bytes, description; padded with spaces such
// that the numbers start at a multiple of 64 bytes.
std::string Header(std::size_t rows, std::size_t columns) {
  std::string header("\x93NUMPY\x01\x00\x00\x00", 10);
  header += "{'descr': '<f4', 'fortran_order': False, 'shape': (" + std::to_string(rows) + ", " +
            std::to_string(columns) + "), }";
  header.append(63 - header.size() % 64, ' ');
  header += '\n';
  const std::size_t length = header.size() - 10;
  header[8] = static_cast<char>(length % 256);
  header[9] = static_cast<char>(length / 256);
  return header;
}

}  // namespace

void WriteNpy(const std::string& path, const std::vector<float>& values, std::size_t columns) {
  OutputFile file(path);
  file.Write(Header(values.size() / columns, columns));
  file.Write(values.data(), values.size() * sizeof(float));
  file.Finish();
}

}  // namespace softsoil
