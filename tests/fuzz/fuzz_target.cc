#include "tests/fuzz/fuzz_target.h"

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>

#include "terrain/input_error.h"

namespace {

// libFuzzer's own limit counts the seconds in which a busy machine does something else.
constexpr double kMostSeconds = 1;  // of computing

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::clock_t start = std::clock();
  try {
    softsoil::Read(std::string(reinterpret_cast<const char*>(data), size));
  } catch (const softsoil::InputError&) {
  }
  const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  if (seconds > kMostSeconds) {
    std::fprintf(stderr, "took %g s of computing, more than %g s\n", seconds, kMostSeconds);
    std::abort();
  }
  return 0;
}
