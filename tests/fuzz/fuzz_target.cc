#include "tests/fuzz/fuzz_target.h"

#include <cstddef>
#include <cstdint>

#include "terrain/input_error.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    softsoil::Read(std::string(reinterpret_cast<const char*>(data), size));
  } catch (const softsoil::InputError&) {
  }
  return 0;
}
