#include "plugin/cli/progress.h"

#include <unistd.h>

#include <cstdio>

namespace softsoil {
namespace {

constexpr double kBetweenLines = 0.2;  // [s]
constexpr char kClearLine[] = "\r\033[K";

}  // namespace

Progress::Progress(double end) : end_(end), terminal_(isatty(STDERR_FILENO) != 0) {}

Progress::~Progress() {
  if (terminal_) std::fputs(kClearLine, stderr);
}

void Progress::Show(double simulated, double wall) {
  if (!terminal_ || wall < next_ || simulated <= 0) return;
  next_ = wall + kBetweenLines;
  const double factor = wall / simulated;
  std::fprintf(stderr, "%s%6.2f of %g s simulated, real-time factor %.2f, %.0f s left", kClearLine,
               simulated, end_, factor, factor * (end_ - simulated));
  std::fflush(stderr);
}

}  // namespace softsoil
