// What a StateWriter passes on.
#pragma once

#include <functional>
#include <vector>

#include "terrain/state_stream.h"

namespace softsoil {

inline std::vector<unsigned char> WrittenBytes(const std::function<void(StateWriter&)>& write) {
  std::vector<unsigned char> bytes;
  StateWriter writer([&](const void* data, std::size_t count) {
    const auto* first = static_cast<const unsigned char*>(data);
    bytes.insert(bytes.end(), first, first + count);
  });
  write(writer);
  writer.Finish();
  return bytes;
}

// Of anything that has Write(StateWriter&).
template <class State>
std::vector<unsigned char> BytesOf(const State& state) {
  return WrittenBytes([&](StateWriter& writer) { state.Write(writer); });
}

}  // namespace softsoil
