// A value that copies share until one of them writes to it.
#pragma once

#include <atomic>
#include <utility>

namespace softsoil {

// Copies may live in different threads; one copy belongs to one thread at a time.
//
// Unlike a std::shared_ptr it may ask whether it is the only owner: the count is read such that
// all that former owners in other threads did to the value has happened before.
template <class T>
class Cow {
 public:
  Cow() = default;  // holds nothing
  Cow(const Cow& other) : shared_(other.shared_) {
    if (shared_ != nullptr) shared_->owners.fetch_add(1, std::memory_order_relaxed);
  }
  Cow(Cow&& other) noexcept : shared_(std::exchange(other.shared_, nullptr)) {}
  Cow& operator=(Cow other) noexcept {
    std::swap(shared_, other.shared_);
    return *this;
  }
  ~Cow() {
    if (shared_ == nullptr) return;
    if (shared_->owners.fetch_sub(1, std::memory_order_acq_rel) == 1) delete shared_;
  }

  template <class... Arguments>
  static Cow Make(Arguments&&... arguments) {
    Cow cow;
    cow.shared_ = new Shared{{1}, T(std::forward<Arguments>(arguments)...)};
    return cow;
  }

  explicit operator bool() const { return shared_ != nullptr; }
  const T& operator*() const { return shared_->value; }
  const T* operator->() const { return &shared_->value; }
  // Null if it holds nothing.
  const T* get() const { return shared_ != nullptr ? &shared_->value : nullptr; }

  bool IsShared() const { return shared_->owners.load(std::memory_order_acquire) > 1; }
  // The value to write to: from now on this owner's alone.
  T& Own() {
    if (IsShared()) *this = Make(shared_->value);
    return shared_->value;
  }

 private:
  struct Shared {
    std::atomic<int> owners;
    T value;
  };
  Shared* shared_ = nullptr;
};

}  // namespace softsoil
