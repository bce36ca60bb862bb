#include "plugin/cli/in_parallel.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <thread>
#include <vector>

namespace softsoil {

void InParallel(int count, int threads, const std::function<void(int)>& work) {
  std::vector<std::exception_ptr> failures(count);
  std::atomic<int> next{0};
  std::atomic<bool> failed{false};
  const auto serve = [&] {
    for (int i = next++; i < count && !failed; i = next++) {
      try {
        work(i);
      } catch (...) {
        failures[i] = std::current_exception();
        failed = true;
      }
    }
  };
  std::vector<std::thread> others;
  for (int t = 1; t < std::min(threads, count); ++t) others.emplace_back(serve);
  serve();
  for (std::thread& other : others) other.join();
  for (const std::exception_ptr& failure : failures) {
    if (failure) std::rethrow_exception(failure);
  }
}

}  // namespace softsoil
