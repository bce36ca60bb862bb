#include "plugin/cli/in_parallel.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <functional>
#include <system_error>
#include <thread>
#include <vector>

namespace softsoil {
namespace {

// Threads that are joined whatever happens. Where the system gives no more of them, those that it
// gave do the work.
class Helpers {
 public:
  Helpers(const std::function<void()>& work, int count) {
    threads_.reserve(std::max(count, 0));
    try {
      for (int t = 0; t < count; ++t) threads_.emplace_back(work);
    } catch (const std::system_error&) {
    }
  }
  ~Helpers() {
    for (std::thread& thread : threads_) thread.join();
  }
  Helpers(const Helpers&) = delete;
  Helpers& operator=(const Helpers&) = delete;

 private:
  std::vector<std::thread> threads_;
};

}  // namespace

void InParallel(int count, int threads, const std::function<void(int)>& work) {
  std::vector<std::exception_ptr> failures(count);
  std::atomic<int> next{0};
  std::atomic<bool> failed{false};
  const auto serve = [&] {
    while (!failed) {
      const int i = next++;  // is worked on in any case, or the first failure were left to chance
      if (i >= count) return;
      try {
        work(i);
      } catch (...) {
        failures[i] = std::current_exception();
        failed = true;
      }
    }
  };
  {
    Helpers helpers(serve, std::min(threads, count) - 1);
    serve();
  }
  for (const std::exception_ptr& failure : failures) {
    if (failure) std::rethrow_exception(failure);
  }
}

}  // namespace softsoil
