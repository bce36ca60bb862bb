#include "plugin/log.h"

#include <cstdio>
#include <mutex>
#include <set>

namespace softsoil {

void Say(const std::string& message) {
  // Never destroyed: a host may step until the very end of the process.
  static auto* const mutex = new std::mutex;
  static auto* const said = new std::set<std::string>;
  const std::lock_guard<std::mutex> lock(*mutex);
  if (said->insert(message).second) std::fprintf(stderr, "softsoil: %s\n", message.c_str());
}

}  // namespace softsoil
