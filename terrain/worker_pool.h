// The threads that update the soil, for all soils of the process.
#pragma once

#include <functional>
#include <future>
#include <memory>

namespace softsoil {

class WorkerPool {
 public:
  // Runs `work` in a new thread, named softsoil; throws std::system_error if the system gives none.
  using StartThread = std::function<void(std::function<void()> work)>;
  static void StartDetached(std::function<void()> work);

  // One worker per processor, made when first needed. A child process after fork() has workers of
  // its own.
  static WorkerPool& Shared();

  // Goes on with fewer workers than `threads` >= 1 if the system gives no more; throws
  // std::runtime_error if it gives none. Workers live to the very end of the process, for a host
  // may step as long.
  explicit WorkerPool(int threads, const StartThread& start = StartDetached);

  int workers() const { return workers_; }

  // Runs `job` on a worker, in the order of the calls; get() of the future rethrows what it threw.
  // A job must not wait for another: all workers might.
  std::future<void> Run(std::function<void()> job);

  // Calls body(i) for every i from 0 to count - 1, in any order: on the calling thread, and on
  // those workers that are free, `threads` in all at most. Throws what a body threw; some i may
  // then have been left out.
  void ForEach(int count, int threads, const std::function<void(int)>& body);

 private:
  struct Queue;
  std::shared_ptr<Queue> queue_;  // the workers hold it too
  int workers_ = 0;
};

}  // namespace softsoil
