#include "terrain/worker_pool.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <system_error>
#include <thread>
#include <vector>

#include "terrain/processors.h"

#if defined(__SANITIZE_THREAD__)
#define SOFTSOIL_TSAN
#elif defined(__has_feature)
#if __has_feature(thread_sanitizer)
#define SOFTSOIL_TSAN
#endif
#endif

namespace softsoil {
namespace {

TEST(WorkerPool, RunsEveryJob) {
  std::atomic<int> done{0};
  std::vector<std::future<void>> jobs;
  for (int i = 0; i < 200; ++i) jobs.push_back(WorkerPool::Shared().Run([&] { ++done; }));
  for (auto& job : jobs) job.get();
  EXPECT_EQ(done, 200);
}

TEST(WorkerPool, RunsJobsBesideTheCaller) {
  std::thread::id worker;
  WorkerPool::Shared().Run([&] { worker = std::this_thread::get_id(); }).get();
  EXPECT_NE(worker, std::this_thread::get_id());
}

TEST(WorkerPool, HandsOnWhatAJobThrows) {
  auto job = WorkerPool::Shared().Run([] { throw std::runtime_error("soil"); });
  EXPECT_THROW(job.get(), std::runtime_error);
  EXPECT_NO_THROW(WorkerPool::Shared().Run([] {}).get()) << "the worker lives on";
}

TEST(WorkerPool, HasAWorkerPerProcessor) {
  EXPECT_EQ(WorkerPool::Shared().workers(), Processors());
}

// A system that gives `threads` threads and no more.
WorkerPool::StartThread SystemThatGives(int threads) {
  return [left = threads](std::function<void()> work) mutable {
    if (left-- == 0) {
      throw std::system_error(std::make_error_code(std::errc::resource_unavailable_try_again));
    }
    WorkerPool::StartDetached(std::move(work));
  };
}

TEST(WorkerPool, GoesOnWithTheThreadsThatTheSystemGives) {
  WorkerPool pool(8, SystemThatGives(2));
  EXPECT_EQ(pool.workers(), 2);
  std::vector<std::future<void>> jobs;
  std::atomic<int> done{0};
  for (int i = 0; i < 20; ++i) jobs.push_back(pool.Run([&] { ++done; }));
  for (auto& job : jobs) job.get();
  EXPECT_EQ(done, 20);
}

TEST(WorkerPool, SaysSoIfTheSystemGivesNoThread) {
  try {
    WorkerPool pool(8, SystemThatGives(0));
    FAIL() << "a pool without workers";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(),
                 "the system gives no thread for the soil: Resource temporarily unavailable");
  }
}

TEST(WorkerPool, CallsTheBodyOfALoopOnceForEveryIndex) {
  for (const int count : {0, 1, 7, 8, 9, 1000}) {
    for (const int threads : {1, 2, 50}) {
      std::vector<std::atomic<int>> calls(count);
      WorkerPool::Shared().ForEach(count, threads, [&](int i) { ++calls[i]; });
      for (const std::atomic<int>& of_one : calls) EXPECT_EQ(of_one, 1);
    }
  }
}

TEST(WorkerPool, RunsALoopInAJobWhileAllWorkersAreBusy) {
  std::vector<std::future<void>> jobs;
  std::atomic<int> done{0};
  for (int job = 0; job < 50; ++job) {
    jobs.push_back(WorkerPool::Shared().Run(
        [&] { WorkerPool::Shared().ForEach(100, 8, [&](int) { ++done; }); }));
  }
  for (auto& job : jobs) job.get();
  EXPECT_EQ(done, 50 * 100);
}

TEST(WorkerPool, HandsOnWhatTheBodyOfALoopThrows) {
  const auto body = [](int i) {
    if (i == 500) throw std::runtime_error("soil");
  };
  for (int repeat = 0; repeat < 20; ++repeat) {
    EXPECT_THROW(WorkerPool::Shared().ForEach(1000, 2, body), std::runtime_error);
  }
}

#ifndef SOFTSOIL_TSAN  // which starts no threads after a fork
TEST(WorkerPool, RunsJobsInAChildProcess) {
  WorkerPool::Shared().Run([] {}).get();
  const pid_t child = fork();
  if (child == 0) {
    alarm(20);  // ends a child that waits for ever
    int done = 0;
    WorkerPool::Shared().Run([&] { ++done; }).get();
    std::_Exit(done == 1 ? 0 : 1);
  }
  int status = -1;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << status;
}
#endif

}  // namespace
}  // namespace softsoil
