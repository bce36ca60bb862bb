#include "plugin/cli/controls.h"

#include <gmock/gmock.h>
#include <unistd.h>

#include <fstream>
#include <limits>

#include "terrain/input_error.h"

namespace softsoil {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
const std::vector<Actuator> kTruck = {
    {"steer", -0.5, 0.5}, {"drive", -kInfinity, kInfinity}, {"brake", 0, 1}};

// Tests run in parallel, each in a process of its own.
std::string File() { return testing::TempDir() + "controls_" + std::to_string(getpid()) + ".csv"; }

Controls FromText(const std::string& text) {
  std::ofstream(File()) << text;
  return Controls(File(), kTruck);
}

// Controls at a time; -1 where the file leaves them as they are.
std::vector<double> At(const Controls& controls, double time) {
  std::vector<double> values(kTruck.size(), -1);
  controls.Apply(time, values.data());
  return values;
}

void ExpectRefused(const std::string& text, const std::string& line_and_rule) {
  try {
    FromText(text);
    FAIL() << "accepted: " << text;
  } catch (const InputError& error) {
    EXPECT_EQ(error.what(), File() + line_and_rule);
  }
}

using testing::ElementsAre;

TEST(Controls, AreLinearBetweenRows) {
  const Controls controls = FromText("time,steer,drive\n0,0,100\n2,0.5,200\n3,0.5,0\n");
  EXPECT_THAT(At(controls, 0), ElementsAre(0, 100, -1));
  EXPECT_THAT(At(controls, 0.5), ElementsAre(0.125, 125, -1));
  EXPECT_THAT(At(controls, 2), ElementsAre(0.5, 200, -1));
  EXPECT_THAT(At(controls, 2.25), ElementsAre(0.5, 150, -1));
}

TEST(Controls, AreHeldBeforeTheFirstAndAfterTheLastRow) {
  const Controls controls = FromText("time,drive\n1,100\n2,200\n");
  EXPECT_THAT(At(controls, 0), ElementsAre(-1, 100, -1));
  EXPECT_THAT(At(controls, 2), ElementsAre(-1, 200, -1));
  EXPECT_THAT(At(controls, 1e9), ElementsAre(-1, 200, -1));
  EXPECT_THAT(At(FromText("time,drive\n1,7\n"), 5), ElementsAre(-1, 7, -1));
}

TEST(Controls, LeaveEverythingWithoutAFile) {
  EXPECT_THAT(At(Controls(), 1), ElementsAre(-1, -1, -1));
}

TEST(Controls, ReachTheActuatorOfTheirColumn) {
  EXPECT_THAT(At(FromText("time,brake,steer\n0,1,0.25\n"), 0), ElementsAre(0.25, -1, 1));
}

TEST(Controls, AllowCommentsBlanksEmptyLinesAndForeignLineEnds) {
  const Controls controls =
      FromText("\xEF\xBB\xBF# a truck\r\n time , drive \r\n\r\n0, 1e2\r\n# then\r\n1,300\r\n");
  EXPECT_THAT(At(controls, 0.5), ElementsAre(-1, 200, -1));
}

TEST(Controls, RefuseABadHeader) {
  ExpectRefused("", ":1: the line with the names of the columns is missing");
  ExpectRefused("t,drive\n0,1\n", ":1: the first column must be time, got \"t\"");
  ExpectRefused("time\n0\n", ":1: a column for an actuator must follow time");
  ExpectRefused("time,gas\n0,1\n",
                ":1: unknown column \"gas\"; the actuators of the model are: steer, drive, brake");
  ExpectRefused("time,drive,\n0,1,2\n",
                ":1: unknown column \"\"; the actuators of the model are: steer, drive, brake");
  ExpectRefused("#\ntime,drive,drive\n0,1,2\n", ":2: column \"drive\" stands here a second time");
  ExpectRefused("time,drive,time\n0,1,2\n", ":1: column \"time\" stands here a second time");
}

TEST(Controls, RefuseABadRow) {
  ExpectRefused("time,drive\n", ":1: a row of numbers must follow the names of the columns");
  ExpectRefused("time,drive\n0\n", ":2: there must be 2 cells as in the header, got 1");
  ExpectRefused("time,drive\n0,1,2\n", ":2: there must be 2 cells as in the header, got 3");
  ExpectRefused("time,drive\n\n0,1\n0,2\n",
                ":4: time must be greater than in the row before, 0 s, got 0");
  ExpectRefused("time,drive\n1,1\n0.5,2\n",
                ":3: time must be greater than in the row before, 1 s, got 0.5");
}

TEST(Controls, RefuseABadCell) {
  ExpectRefused("time,drive\n0,\n", ":2: drive is missing");
  ExpectRefused("time,drive\n,5\n", ":2: time is missing");
  ExpectRefused("time,drive\n0,forty\n", ":2: drive must be a finite number, got \"forty\"");
  ExpectRefused("time,drive\n0,4x\n", ":2: drive must be a finite number, got \"4x\"");
  ExpectRefused("time,drive\n0,nan\n", ":2: drive must be a finite number, got \"nan\"");
  ExpectRefused("time,drive\n0,1e999\n", ":2: drive must be a finite number, got \"1e999\"");
  ExpectRefused("time,steer\n0,0.6\n", ":2: steer must be -0.5 to 0.5, got 0.6");
  ExpectRefused("time,brake\n0,0\n1,-0.1\n", ":3: brake must be 0 to 1, got -0.1");
}

TEST(Controls, RefuseAFileThatCannotBeRead) {
  EXPECT_THAT(
      [] { Controls("/nowhere/c.csv", kTruck); },
      testing::ThrowsMessage<InputError>("/nowhere/c.csv: cannot read: No such file or directory"));
  EXPECT_THAT([] { Controls("/", kTruck); },
              testing::ThrowsMessage<InputError>("/: is a folder, not a file"));
}

}  // namespace
}  // namespace softsoil
