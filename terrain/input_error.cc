#include "terrain/input_error.h"

#include <charconv>
#include <cmath>
#include <system_error>

namespace softsoil {

std::string Shown(double value) {
  const double size = std::abs(value);
  const bool is_handy = value == 0 || (size >= 1e-5 && size < 1e7);
  const auto format = is_handy ? std::chars_format::fixed : std::chars_format::scientific;
  char text[48];
  return std::string(text, std::to_chars(text, text + sizeof text, value, format).ptr);
}

std::string Rounded(double value, int digits) {
  char text[48];
  const auto end =
      std::to_chars(text, text + sizeof text, value, std::chars_format::scientific, digits - 1).ptr;
  double rounded = value;
  ParseNumber(std::string(text, end), &rounded);
  return Shown(rounded);
}

std::string Quoted(const std::string& word) {
  constexpr std::size_t kMost = 40;
  std::string text = word.substr(0, kMost);
  for (char& c : text) {
    if (c < ' ' || c > '~') c = '?';
  }
  return '"' + text + (word.size() > kMost ? "...\"" : "\"");
}

std::string Listed(const std::vector<std::string>& words) {
  std::string list;
  for (const std::string& word : words) list += (list.empty() ? "" : ", ") + word;
  return list;
}

bool ParseNumber(const std::string& text, double* value) {
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, *value);
  return error == std::errc() && stop == end && std::isfinite(*value);
}

}  // namespace softsoil
