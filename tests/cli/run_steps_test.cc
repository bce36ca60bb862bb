#include "plugin/cli/run_steps.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "terrain/input_error.h"

namespace softsoil {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

std::vector<long> Rows(const RunSteps& steps, double interval) {
  std::vector<long> rows;
  for (long step = steps.first(); step < steps.last(); ++step) {
    if (steps.Begins(step, interval)) rows.push_back(step);
  }
  return rows;
}

TEST(RunSteps, CountFromZeroOfSimulatedTime) {
  const RunSteps steps(0.2340000000000002, 0.1, 0.001);
  EXPECT_EQ(steps.first(), 234);
  EXPECT_EQ(steps.last(), 334);
  EXPECT_DOUBLE_EQ(steps.start(), 0.234);
  EXPECT_DOUBLE_EQ(steps.duration(), 0.1);
}

TEST(RunSteps, BeginIntervalsAtTheNearestStepWhereverTheRunBegins) {
  EXPECT_THAT(Rows({0, 0.02, 0.001}, 0.005), ElementsAre(0, 5, 10, 15));
  EXPECT_THAT(Rows({0.007, 0.013, 0.001}, 0.005), ElementsAre(10, 15));
  EXPECT_THAT(Rows({0.005, 0.005, 0.001}, 0.005), ElementsAre(5));
  EXPECT_THAT(Rows({0, 0.01, 0.001}, 0.0026), ElementsAre(0, 3, 5, 8));
  EXPECT_THAT(Rows({0.004, 0.006, 0.001}, 0.0026), ElementsAre(5, 8));
}

TEST(RunSteps, BeginAnIntervalEachWhereIntervalsAreShorter) {
  for (const double interval : {0.001, 0.0004, std::numeric_limits<double>::denorm_min()}) {
    EXPECT_THAT(Rows({0.007, 0.003, 0.001}, interval), ElementsAre(7, 8, 9)) << interval;
  }
}

TEST(RunSteps, AreFoundByTheirTimeFromTheFirstToTheEnd) {
  const RunSteps steps(0.3, 0.2, 0.001);
  EXPECT_EQ(steps.Nearest("--at", 0.2996), 300);
  EXPECT_EQ(steps.Nearest("--at", 0.3), 300);
  EXPECT_EQ(steps.Nearest("--at", 0.4004), 400);
  EXPECT_EQ(steps.Nearest("--at", 0.5), 500);
  for (const double time : {0.299, 0.501, -1.0, 1e300, -1e300, std::nan("")}) {
    EXPECT_THAT([&] { steps.Nearest("--at", time); },
                ThrowsMessage<InputError>(
                    HasSubstr("--at must be within the run, 0.3 to 0.5 s, got " + Shown(time))));
  }
}

TEST(RunSteps, AreNeitherNoneNorWithoutEnd) {
  for (const double time : {0.0004, 1e8}) {
    EXPECT_THAT([&] { RunSteps(0, time, 0.001); },
                ThrowsMessage<InputError>(HasSubstr("--time must be one time step, 0.001 s, to ")));
  }
  for (const double start : {-0.001, 1e8, std::nan("")}) {
    EXPECT_THAT([&] { RunSteps(start, 1, 0.001); },
                ThrowsMessage<InputError>(HasSubstr("a run must begin at 0 s to ")));
  }
}

}  // namespace
}  // namespace softsoil
