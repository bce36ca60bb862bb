#include "terrain/soil_clock.h"

#include <algorithm>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>

namespace softsoil {

struct WorkerPool::Impl {
  std::mutex mutex;
  std::condition_variable wake;
  std::deque<std::packaged_task<void()>> jobs;

  [[noreturn]] void Work() {
    for (;;) {
      std::packaged_task<void()> job;
      {
        std::unique_lock<std::mutex> lock(mutex);
        wake.wait(lock, [this] { return !jobs.empty(); });
        job = std::move(jobs.front());
        jobs.pop_front();
      }
      job();
    }
  }
};

WorkerPool::WorkerPool(int threads) : impl_(new Impl) {
  for (int i = 0; i < threads; ++i) std::thread([this] { impl_->Work(); }).detach();
}

WorkerPool& WorkerPool::Shared() {
  static auto* const pool =  // never destroyed: jobs may come while the process ends
      new WorkerPool(static_cast<int>(std::max(1u, std::thread::hardware_concurrency())));
  return *pool;
}

std::future<void> WorkerPool::Run(std::function<void()> job) {
  std::packaged_task<void()> task(std::move(job));
  std::future<void> done = task.get_future();
  {
    const std::lock_guard<std::mutex> lock(impl_->mutex);
    impl_->jobs.push_back(std::move(task));
  }
  impl_->wake.notify_one();
  return done;
}

}  // namespace softsoil
