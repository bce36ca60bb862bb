#include "plugin/cli/in_parallel.h"

#include <gmock/gmock.h>
#include <pthread.h>

#include <stdexcept>
#include <string>
#include <system_error>
#include <thread>
#include <vector>

namespace softsoil {
namespace {

class Threads : public testing::TestWithParam<int> {};

TEST_P(Threads, DoEveryCaseOnce) {
  std::vector<int> done(50, 0);
  InParallel(50, GetParam(), [&done](int i) { ++done[i]; });
  EXPECT_EQ(done, std::vector<int>(50, 1));
}

TEST_P(Threads, PassOnTheFirstFailure) {
  try {
    InParallel(2, GetParam(), [](int i) { throw std::runtime_error("case " + std::to_string(i)); });
    FAIL() << "no exception";
  } catch (const std::runtime_error& error) {
    EXPECT_EQ(std::string(error.what()), "case 0");
  }
}

TEST_P(Threads, MayHaveNothingToDo) {
  InParallel(0, GetParam(), [](int) { FAIL(); });
}

#ifdef __GLIBC__
// Asks for stacks beyond any address space while it lives.
class NoMoreThreads {
 public:
  NoMoreThreads() {
    pthread_getattr_default_np(&before_);
    pthread_attr_t huge = before_;
    pthread_attr_setstacksize(&huge, std::size_t{1} << 50);
    pthread_setattr_default_np(&huge);
  }
  ~NoMoreThreads() { pthread_setattr_default_np(&before_); }

 private:
  pthread_attr_t before_;
};

TEST(InParallel, DoesEveryCaseWhereTheSystemGivesNoThread) {
  const NoMoreThreads none;
  EXPECT_THROW(std::thread([] {}).join(), std::system_error);
  std::vector<int> done(50, 0);
  InParallel(50, 4, [&done](int i) { ++done[i]; });
  EXPECT_EQ(done, std::vector<int>(50, 1));
}
#endif

INSTANTIATE_TEST_SUITE_P(InParallel, Threads, testing::Values(1, 2, 8));

}  // namespace
}  // namespace softsoil
