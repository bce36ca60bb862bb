// A wheel on an arm that circles for a minute: once the circle is closed, memory grows no more.
#include <gtest/gtest.h>

#include <string>

#include "plugin/softsoil.h"
#include "tests/faults/failing_memory.h"
#include "tests/plugin/mjcf.h"

namespace softsoil {
namespace {

constexpr long kMegabyte = 1000000;

std::string CirclingWheel(int nuserdata) {
  return "<mujoco><option timestep=\"0.002\"/><size nuserdata=\"" + std::to_string(nuserdata) +
         R"("/>
    <custom>
      <text name="softsoil_soil" data="upland_sandy_loam"/>
      <numeric name="softsoil_grid_spacing" data="0.1"/>
      <numeric name="softsoil_volume_height" data="0.1"/>
      <numeric name="softsoil_volumes" data="8"/>
      <numeric name="softsoil_history" data="2"/>
    </custom>
    <worldbody>
      <geom type="plane" size="9 9 1" contype="2" conaffinity="0"/>
      <body name="arm" pos="0 0 .4">
        <inertial pos="1 0 0" mass="50" diaginertia="1 20 20"/>
        <joint axis="0 0 1"/>
        <body name="hub" pos="2 0 0">
          <inertial pos="0 0 0" mass="150" diaginertia="5 5 5"/>
          <joint type="slide" axis="0 0 1" damping="3000"/>
          <body name="wheel">
            <joint name="spin" axis="1 0 0"/>
            <geom type="cylinder" zaxis="1 0 0" size=".4 .1" mass="10"/>
          </body>
        </body>
      </body>
    </worldbody>
    <actuator><velocity joint="spin" kv="500"/></actuator></mujoco>)";
}

struct Memory {
  softsoilGround ground = {};
  long allocated = 0;  // [bytes]
};

struct Circling {
  explicit Circling(int nuserdata) : m(Load(CirclingWheel(nuserdata))), d(MakeData(m)) {
    EXPECT_EQ(softsoil_attach(m.get(), d.get(), nullptr), 0) << softsoil_error();
    d->ctrl[0] = -4;  // [rad/s]
  }
  Memory After(double time) {
    while (d->time < time) mj_step(m.get(), d.get());
    Memory memory;
    EXPECT_EQ(softsoil_ground(d.get(), &memory.ground), 0) << softsoil_error();
    memory.allocated = AllocatedBytes();
    return memory;
  }

  Model m;
  Data d;
};

class LongDrive : public testing::TestWithParam<int> {};

TEST_P(LongDrive, TakesNoMoreMemoryOnceTheCircleIsClosed) {
  Circling drive(GetParam());
  const Memory early = drive.After(2), half = drive.After(30), end = drive.After(60);
  EXPECT_GT(drive.d->qpos[0], 4 * 6.3) << "four circles [rad]";
  EXPECT_GT(half.ground.columns, early.ground.columns);
  EXPECT_EQ(end.ground.columns, half.ground.columns);
  EXPECT_EQ(end.ground.bytes, half.ground.bytes);
  RecordProperty("bytes", static_cast<int>(end.ground.bytes));
  RecordProperty("allocated_half", static_cast<int>(half.allocated));
  RecordProperty("allocated_end", static_cast<int>(end.allocated));
  // The history of 2 MB is more or less full.
  const long slack = GetParam() > 0 ? 2 * kMegabyte : kMegabyte / 5;
  EXPECT_LT(end.allocated - half.allocated, slack);
  EXPECT_LT(end.allocated, static_cast<long>(end.ground.bytes) + 8 * kMegabyte);
  ExpectNoWarnings(drive.d);
}

INSTANTIATE_TEST_SUITE_P(WithoutAndWithHistory, LongDrive, testing::Values(0, 2));

}  // namespace
}  // namespace softsoil
