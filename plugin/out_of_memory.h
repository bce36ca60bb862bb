// Messages that can be kept and told when there is no memory.
#pragma once

#include <exception>
#include <new>
#include <string>

namespace softsoil {

// So short that a std::string holds it without memory of its own.
constexpr char kOutOfMemory[] = "out of memory";
static_assert(sizeof kOutOfMemory <= 16);

inline const char* MessageOf(const std::exception& error) {
  return dynamic_cast<const std::bad_alloc*>(&error) != nullptr ? kOutOfMemory : error.what();
}

// `kept` becomes the message, or tells that there is no memory for it.
inline void Keep(const char* message, std::string* kept) noexcept {
  try {
    *kept = message;
  } catch (const std::bad_alloc&) {
    *kept = kOutOfMemory;
  }
}

}  // namespace softsoil
