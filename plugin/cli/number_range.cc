#include "plugin/cli/number_range.h"

#include <cmath>

#include "terrain/input_error.h"

namespace softsoil {
namespace {

std::vector<std::string> Split(const std::string& text, char separator) {
  std::vector<std::string> parts(1);
  for (const char c : text) {
    if (c == separator) {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  return parts;
}

double Number(const std::string& word) {
  double value;
  if (ParseNumber(word, &value)) return value;
  throw InputError("must be numbers as in 0.2 or 0.05,0.1,0.3, or first:last:step, got \"" + word +
                   "\"");
}

double AsWritten(double value) {
  ParseNumber(Rounded(value, 12), &value);
  return value;
}

void CheckRange(double first, double last, double step) {
  if (step <= 0) throw InputError("the step of a range must be > 0, got " + Shown(step));
  if (last < first) {
    throw InputError("a range must not end below its first number " + Shown(first) + ", got " +
                     Shown(last));
  }
}

void CheckCount(double count) {
  if (count > kMostNumbers) {
    throw InputError("must be at most " + std::to_string(kMostNumbers) + " numbers, got " +
                     Shown(count));
  }
}

// Numbers of one part between commas.
std::vector<double> Range(const std::string& text) {
  const std::vector<std::string> words = Split(text, ':');
  if (words.size() == 1) return {Number(text)};
  if (words.size() != 3) {
    throw InputError("a range must be first:last:step, got \"" + text + "\"");
  }
  const double first = Number(words[0]), last = Number(words[1]), step = Number(words[2]);
  CheckRange(first, last, step);
  const double steps = std::floor((last - first) / step * (1 + 1e-9));
  CheckCount(steps + 1);
  std::vector<double> numbers;
  for (int k = 0; k <= steps; ++k) numbers.push_back(AsWritten(first + k * step));
  return numbers;
}

}  // namespace

std::vector<double> NumbersIn(const std::string& name, const std::string& text) {
  return At(name, [&text] {
    std::vector<double> numbers;
    for (const std::string& part : Split(text, ',')) {
      for (const double number : Range(part)) numbers.push_back(number);
      CheckCount(numbers.size());
    }
    return numbers;
  });
}

}  // namespace softsoil
