#include "plugin/cli/in_parallel.h"

#include <gmock/gmock.h>

#include <stdexcept>
#include <string>
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

INSTANTIATE_TEST_SUITE_P(InParallel, Threads, testing::Values(1, 2, 8));

}  // namespace
}  // namespace softsoil
