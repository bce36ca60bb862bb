#include "plugin/failure.h"

#include <cstdio>
#include <cstdlib>

#include "plugin/log.h"
#include "plugin/out_of_memory.h"

namespace softsoil {

void Note(const std::exception& error, Failure* failure) {
  failure->happened = true;
  std::snprintf(failure->message, kLongestMessage, "%s", MessageOf(error));
}

void Stop(const Failure& failure, void (*handler)(const char*)) {
  if (handler != nullptr) {
    char message[kLongestMessage + 20];
    std::snprintf(message, sizeof message, "softsoil: %s", failure.message);
    handler(message);
    return;
  }
  // Neither mju_error(), which waits for a key, nor exit(), which runs destructors beside threads
  // that still simulate.
  Say(failure.message);
  std::fflush(stdout);  // not all files: another thread may be waiting for input
  std::_Exit(EXIT_FAILURE);
}

}  // namespace softsoil
