#include "terrain/worker_pool.h"

#include <pthread.h>

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <deque>
#include <exception>
#include <mutex>
#include <new>
#include <stdexcept>
#include <string>
#include <system_error>
#include <thread>
#include <utility>

#include "terrain/processors.h"

namespace softsoil {
namespace {

struct SharedPool {
  std::mutex making;
  std::atomic<WorkerPool*> pool{nullptr};
};

// Never destroyed: jobs may come while the process ends. A child process starts with a new one, for
// it has none of its parent's threads, and the parent's locks may be held for ever.
std::atomic<SharedPool*>& CurrentPool() {
  static std::atomic<SharedPool*> current{[] {
    pthread_atfork(nullptr, nullptr, [] { CurrentPool() = new SharedPool; });
    return new SharedPool;
  }()};
  return current;
}

// A loop that its caller shares with whoever has time. It ends when the caller finds nothing left
// to do and no helper is at work any more; helpers that come later find it closed.
class SharedLoop {
 public:
  SharedLoop(int count, const std::function<void(int)>& body) : count_(count), body_(body) {}

  void Help() {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      if (closed_) return;
      ++helpers_;
    }
    Work();
    const std::lock_guard<std::mutex> lock(mutex_);
    --helpers_;
    left_.notify_one();
  }

  void RunToTheEnd() {
    Work();
    std::unique_lock<std::mutex> lock(mutex_);
    closed_ = true;
    left_.wait(lock, [this] { return helpers_ == 0; });
    if (failure_ != nullptr) std::rethrow_exception(failure_);
  }

 private:
  static constexpr int kChunk = 8;

  void Work() {
    try {
      for (int first = next_.fetch_add(kChunk); first < count_; first = next_.fetch_add(kChunk)) {
        for (int i = first; i < std::min(first + kChunk, count_); ++i) body_(i);
      }
    } catch (...) {
      const std::lock_guard<std::mutex> lock(mutex_);
      failure_ = std::current_exception();
      next_ = count_;
    }
  }

  const int count_;
  const std::function<void(int)>& body_;  // used until the loop is closed
  std::atomic<int> next_{0};
  std::mutex mutex_;  // of what follows
  std::condition_variable left_;
  int helpers_ = 0;
  bool closed_ = false;
  std::exception_ptr failure_;
};

}  // namespace

struct WorkerPool::Queue {
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

void WorkerPool::StartDetached(std::function<void()> work) {
  std::thread thread(std::move(work));
  pthread_setname_np(thread.native_handle(), "softsoil");  // threads that it starts inherit it
  thread.detach();
}

WorkerPool& WorkerPool::Shared() {
  SharedPool& shared = *CurrentPool().load();
  if (WorkerPool* pool = shared.pool.load()) return *pool;
  const std::lock_guard<std::mutex> lock(shared.making);
  if (shared.pool.load() == nullptr) shared.pool = new WorkerPool(Processors());
  return *shared.pool.load();
}

WorkerPool::WorkerPool(int threads, const StartThread& start) : queue_(std::make_shared<Queue>()) {
  try {
    for (; workers_ < threads; ++workers_) start([queue = queue_] { queue->Work(); });
  } catch (const std::system_error& error) {
    if (workers_ > 0) return;
    throw std::runtime_error("the system gives no thread for the soil: " +
                             std::string(error.what()));
  }
}

std::future<void> WorkerPool::Run(std::function<void()> job) {
  std::packaged_task<void()> task(std::move(job));
  std::future<void> done = task.get_future();
  {
    const std::lock_guard<std::mutex> lock(queue_->mutex);
    queue_->jobs.push_back(std::move(task));
  }
  queue_->wake.notify_one();
  return done;
}

void WorkerPool::ForEach(int count, int threads, const std::function<void(int)>& body) {
  const auto loop = std::make_shared<SharedLoop>(count, body);
  try {
    for (int helper = 1; helper < std::min({threads, workers_, count}); ++helper) {
      Run([loop] { loop->Help(); });
    }
  } catch (const std::bad_alloc&) {  // then those that came help; they need `body` to the end
  }
  loop->RunToTheEnd();
}

}  // namespace softsoil
