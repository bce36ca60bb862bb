#include "terrain/state_stream.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "terrain/input_error.h"

namespace softsoil {
namespace {

constexpr std::size_t kBufferBytes = 1 << 16;
static_assert(kBufferBytes % sizeof(std::uint64_t) == 0);
static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__, "files hold numbers as memory does");

std::uint64_t Mixed(std::uint64_t hash, std::uint64_t word) {
  hash = (hash ^ word) * 0xff51afd7ed558ccd;  // any large odd number
  return hash ^ (hash >> 32);
}

}  // namespace

void StateHash::Add(const void* bytes, std::size_t count) {
  const auto* next = static_cast<const unsigned char*>(bytes);
  const std::size_t rest = count % sizeof(std::uint64_t);
  std::uint64_t word = 0;
  for (const auto* const end = next + (count - rest); next != end; next += sizeof word) {
    std::memcpy(&word, next, sizeof word);
    value_ = Mixed(value_, word);
  }
  if (rest == 0) return;
  word = 0;
  std::memcpy(&word, next, rest);
  value_ = Mixed(Mixed(value_, word), count);
}

void StateWriter::PutText(const std::string& text) {
  Put(static_cast<std::uint64_t>(text.size()));
  PutBytes(text.data(), text.size());
}

void StateWriter::PutBytes(const void* bytes, std::size_t count) {
  const auto* next = static_cast<const unsigned char*>(bytes);
  while (count > 0) {
    const std::size_t part = std::min(count, kBufferBytes - buffer_.size());
    buffer_.insert(buffer_.end(), next, next + part);
    if (buffer_.size() == kBufferBytes) Flush();
    next += part;
    count -= part;
  }
}

std::uint64_t StateWriter::Finish() {
  Flush();
  return hash_.value();
}

void StateWriter::Flush() {
  hash_.Add(buffer_.data(), buffer_.size());
  if (sink_) sink_(buffer_.data(), buffer_.size());
  buffer_.clear();
}

bool StateReader::GetFlag() {
  const auto flag = Get<std::uint8_t>();
  Require(flag <= 1, "a flag");
  return flag == 1;
}

double StateReader::GetFinite() {
  double value;
  GetFinite(&value, 1);
  return value;
}

void StateReader::GetFinite(double* values, std::size_t count) {
  GetBytes(values, count * sizeof(double));
  Require(std::all_of(values, values + count, [](double v) { return std::isfinite(v); }),
          "a number");
}

std::string StateReader::GetText() {
  std::string text(Count(1), '\0');
  GetBytes(text.data(), text.size());
  return text;
}

void StateReader::GetBytes(void* bytes, std::size_t count) {
  Require(count <= left_, "its length");
  if (count > 0) std::memcpy(bytes, next_, count);
  next_ += count;
  left_ -= count;
}

std::size_t StateReader::Count(std::size_t bytes) {
  const auto count = Get<std::uint64_t>();
  Require(count <= left_ / bytes, "its length");
  return count;
}

void StateReader::Require(bool valid, const char* what) const {
  if (!valid) throw InputError("the state is damaged: " + std::string(what) + " is not valid");
}

}  // namespace softsoil
