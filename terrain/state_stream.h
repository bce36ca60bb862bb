// State as bytes: what is written to a file, read from it, and hashed. One order for all three.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <type_traits>
#include <vector>

namespace softsoil {

// Whether equal values have equal bytes.
template <class T>
constexpr bool kHasNoGaps = std::is_arithmetic_v<T> || std::has_unique_object_representations_v<T>;

// 64 bits over a sequence of bytes, for finding what differs or is damaged; no protection against
// those who mean harm.
class StateHash {
 public:
  // Any number of bytes; all calls but the last with a multiple of 8.
  void Add(const void* bytes, std::size_t count);
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0x9e3779b97f4a7c15;
};

class StateWriter {
 public:
  using Sink = std::function<void(const void* bytes, std::size_t count)>;
  // Without a sink it only hashes.
  explicit StateWriter(Sink sink = {}) : sink_(std::move(sink)) {}

  template <class T>
  void Put(const T& value) {
    static_assert(kHasNoGaps<T>);
    PutBytes(&value, sizeof value);
  }
  template <class T>
  void PutAll(const std::vector<T>& values) {
    static_assert(kHasNoGaps<T>);
    Put(static_cast<std::uint64_t>(values.size()));
    PutBytes(values.data(), values.size() * sizeof(T));
  }
  void PutText(const std::string& text);
  void PutBytes(const void* bytes, std::size_t count);

  // Of all that was put. Passes the rest on to the sink.
  std::uint64_t Finish();

 private:
  void Flush();

  Sink sink_;
  StateHash hash_;
  std::vector<unsigned char> buffer_;
};

// Reads what a StateWriter wrote. Throws InputError where the bytes do not hold what is asked for.
class StateReader {
 public:
  // The bytes must outlive the object.
  StateReader(const unsigned char* bytes, std::size_t count) : next_(bytes), left_(count) {}

  template <class T>
  T Get() {
    static_assert(kHasNoGaps<T> && !std::is_same_v<T, bool>);
    T value;
    GetBytes(&value, sizeof value);
    return value;
  }
  template <class T>
  std::vector<T> GetAll() {
    std::vector<T> values(Count(sizeof(T)));
    GetBytes(values.data(), values.size() * sizeof(T));
    return values;
  }
  bool GetFlag();
  double GetFinite();
  void GetFinite(double* values, std::size_t count);
  std::string GetText();
  void GetBytes(void* bytes, std::size_t count);
  // A number of things to come that take at least `bytes` > 0 each.
  std::size_t Count(std::size_t bytes);

  // Throws InputError that says that `what` is not valid.
  void Require(bool valid, const char* what) const;
  std::size_t left() const { return left_; }

 private:
  const unsigned char* next_;
  std::size_t left_;
};

}  // namespace softsoil
