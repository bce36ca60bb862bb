// Splits texts.
#pragma once

#include <string>
#include <vector>

namespace softsoil {

// The parts of a text between any of the `separators`, empty ones left out.
inline std::vector<std::string> Words(const std::string& text, const char* separators) {
  std::vector<std::string> words;
  for (std::size_t end = 0, begin = 0; end != std::string::npos; begin = end + 1) {
    end = text.find_first_of(separators, begin);
    const std::string word = text.substr(begin, end - begin);
    if (!word.empty()) words.push_back(word);
  }
  return words;
}

}  // namespace softsoil
