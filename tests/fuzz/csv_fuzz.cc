// Every kind of CSV file that the program reads.
#include <sys/mman.h>
#include <unistd.h>

#include <limits>
#include <system_error>

#include "contact/tire_measurements.h"
#include "plugin/cli/controls.h"
#include "terrain/bearing_fit.h"
#include "terrain/input_error.h"
#include "terrain/shear_fit.h"
#include "tests/fuzz/fuzz_target.h"

namespace softsoil {
namespace {

constexpr double kRadius = 0.9;  // [m]  of the tire
constexpr double kInfinity = std::numeric_limits<double>::infinity();

// A file in memory, used again for every input.
class MemoryFile {
 public:
  MemoryFile() : descriptor_(memfd_create("csv", 0)), path_("/proc/self/fd/") {
    path_ += std::to_string(descriptor_);
  }
  const std::string& With(const std::string& text) {
    if (ftruncate(descriptor_, 0) != 0 ||
        pwrite(descriptor_, text.data(), text.size(), 0) != static_cast<ssize_t>(text.size())) {
      throw std::system_error(errno, std::generic_category(), path_);
    }
    return path_;
  }

 private:
  int descriptor_;
  std::string path_;
};

// A column that one kind of file alone has, and the reader of that kind.
struct Kind {
  const char* column;
  void (*read)(const std::string& file);
};
constexpr Kind kKinds[] = {
    {"pressure", [](const std::string& file) { ReadPlateSinkage(file); }},
    {"shear_stress", [](const std::string& file) { ReadShearTest(file); }},
    {"load", [](const std::string& file) { ReadLoadDeflection(file, kRadius); }},
    {"contact_width", [](const std::string& file) { ReadContactWidths(file, kRadius); }},
    {"time",
     [](const std::string& file) {
       Controls(file, {{"steer", -0.5, 0.5}, {"drive", -kInfinity, kInfinity}});
     }},
};

}  // namespace

void Read(const std::string& text) {
  static MemoryFile memory;
  const std::string& file = memory.With(text);
  for (const Kind& kind : kKinds) {
    if (text.find(kind.column) == std::string::npos) continue;
    try {
      kind.read(file);
    } catch (const InputError&) {
    }
  }
}

}  // namespace softsoil
