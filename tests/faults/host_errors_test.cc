// Hosts that leave a step in the middle, diverge, or do odd things with time: the soil goes on.
#include <gmock/gmock.h>
#include <mujoco/mujoco.h>

#include <csetjmp>
#include <limits>
#include <stdexcept>

#include "tests/faults/driven_wheel.h"

namespace softsoil {
namespace {

using testing::HasSubstr;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kFuture = 0.05;  // [s]

std::jmp_buf out_of_the_step;

// A mjcb_control that ends every step by mju_error(), as long as it lives.
class FailingControl {
 public:
  explicit FailingControl(void (*handler)(const char*)) {
    mju_user_error = handler;
    mjcb_control = [](const mjModel*, mjData*) { mju_error("the control gives up"); };
  }
  ~FailingControl() {
    mjcb_control = nullptr;
    mju_user_error = nullptr;
  }
};

void StepAndThrow(DrivenWheel& wheel) {
  const FailingControl control([](const char* what) { throw std::runtime_error(what); });
  EXPECT_THROW(wheel.Step(), std::runtime_error);
}

void StepAndJump(DrivenWheel& wheel) {
  const FailingControl control([](const char*) { std::longjmp(out_of_the_step, 1); });
  if (setjmp(out_of_the_step) == 0) {
    wheel.Step();
    ADD_FAILURE() << "the step should not end";
  }
}

// The step is begun anew; nothing of the broken one is left.
template <class BreakStep>
void ExpectSameFutureWithBrokenSteps(const BreakStep& break_step) {
  DrivenWheel wheel;
  const std::uint64_t plain = wheel.Future(kFuture);
  const int pstack = wheel.saved->pstack;
  wheel.PutBack();
  while (wheel.d->time < wheel.saved->time + kFuture - 1e-9) {
    for (int i = 0; i < 3; ++i) break_step(wheel);
    wheel.d->pstack = pstack;
    wheel.Step();
  }
  EXPECT_EQ(HashOf(wheel.d.get()), plain);
}

TEST(HostThatLeavesAStep, ByAnExceptionFindsTheSoilAsItWas) {
  ExpectSameFutureWithBrokenSteps(StepAndThrow);
}

TEST(HostThatLeavesAStep, ByLongjmpFindsTheSoilAsItWas) {
  ExpectSameFutureWithBrokenSteps(StepAndJump);
}

// One number of the mjData becomes `value` amid a drive.
template <class Spoil>
std::string SaidOf(DrivenWheel& wheel, const Spoil& spoil) {
  testing::internal::CaptureStderr();
  spoil(wheel);
  for (int i = 0; i < 20; ++i) {
    mj_forward(wheel.m.get(), wheel.d.get());  // mj_step() would reset the mjData
    wheel.d->time += wheel.m->opt.timestep;
  }
  const std::string said = testing::internal::GetCapturedStderr();
  EXPECT_EQ(softsoil_wheel_count(wheel.d.get()), 1) << softsoil_error();
  for (const auto& [node, height] : HeightsOf(wheel.d.get())) EXPECT_TRUE(std::isfinite(height));
  for (mjWarningStat& warning : wheel.d->warning) warning.number = 0;
  return said;
}

// Nothing that is deformed is lost; a rut may have sunk further, and soil slides into it a little.
void ExpectRuts(const Heights& ruts, const mjData* d) {
  const Heights now = HeightsOf(d);
  int deep = 0;
  for (const auto& [node, height] : ruts) {
    if (height > -0.02) continue;
    EXPECT_LT(now.at(node), height / 2);
    ++deep;
  }
  EXPECT_GT(deep, 0);
}

template <class Spoil>
void ExpectCleanAfterReset(const Spoil& spoil) {
  DrivenWheel wheel;
  const Heights ruts = HeightsOf(wheel.d.get());
  const auto drive = [&] {
    mj_resetData(wheel.m.get(), wheel.d.get());
    wheel.d->qvel[0] = 4;
    wheel.Run(0.1);
    return HashOf(wheel.d.get());
  };
  const std::uint64_t plain = drive();
  SaidOf(wheel, spoil);
  ExpectRuts(ruts, wheel.d.get());
  EXPECT_EQ(drive(), plain);
}

TEST(SimulationThatDiverges, IsToldWhatIsNotFinite) {
  DrivenWheel wheel;
  EXPECT_THAT(SaidOf(wheel, [](DrivenWheel& w) { w.d->time = kNan; }),
              HasSubstr("softsoil: the time is not finite; no soil forces while that lasts"));
}

TEST(SimulationThatDiverges, LeavesTheRutsAndIsCleanAfterAReset) {
  for (const double value : {kNan, kInfinity, -kInfinity}) {
    SCOPED_TRACE(value);
    ExpectCleanAfterReset([&](DrivenWheel& wheel) { wheel.d->qpos[1] = value; });
    ExpectCleanAfterReset([&](DrivenWheel& wheel) { wheel.d->qvel[2] = value; });
    ExpectCleanAfterReset([&](DrivenWheel& wheel) { wheel.d->time = value; });
  }
}

// mj_step() resets a mjData that is not finite by itself.
TEST(SimulationThatDiverges, IsCleanAfterMujocosOwnReset) {
  DrivenWheel wheel;
  testing::internal::CaptureStdout();
  mju_user_warning = [](const char*) {};
  wheel.d->qpos[1] = kNan;
  wheel.Run(0.1);
  mju_user_warning = nullptr;
  testing::internal::GetCapturedStdout();
  const std::uint64_t reset = HashOf(wheel.d.get());
  for (mjWarningStat& warning : wheel.d->warning) warning.number = 0;
  Simulation fresh(WheelOnLooseSoil());
  fresh.Run(wheel.d->time);
  EXPECT_EQ(reset, HashOf(fresh.d.get()));
}

struct Throw {
  double x, z, speed;  // [m], [m], [m/s] upwards
};

TEST(WheelThrownAnywhere, LeavesTheSoilUsable) {
  testing::internal::CaptureStderr();
  for (const Throw& t : {Throw{1e4, 0, 0},
                         {1e8, 0, 0},
                         {-1e8, -5, -100},
                         {0, 1e5, 0},
                         {0, -1e5, 0},
                         {0, -1e7, -1e3},
                         {0, -3, -100},
                         {0, 50, -300}}) {
    SCOPED_TRACE(testing::Message() << t.x << " m, " << t.z << " m, " << t.speed << " m/s");
    DrivenWheel wheel;
    const Heights ruts = HeightsOf(wheel.d.get());
    const std::uint64_t plain = wheel.Future(kFuture);
    wheel.PutBack();
    wheel.Run(0.005);  // to the middle of a soil period
    wheel.d->qpos[0] += t.x;
    wheel.d->qpos[1] += t.z;
    wheel.d->qvel[1] = t.speed;
    wheel.Run(0.1);
    EXPECT_EQ(softsoil_wheel_count(wheel.d.get()), 1) << softsoil_error();
    for (int k = 0; k < 6; ++k) EXPECT_TRUE(std::isfinite(wheel.Row()[k])) << k;
    ExpectRuts(ruts, wheel.d.get());
    softsoilGround ground;
    EXPECT_EQ(softsoil_ground(wheel.d.get(), &ground), 0);
    EXPECT_LT(ground.bytes, 200u << 20);
    EXPECT_EQ(wheel.Future(kFuture), plain);
    for (mjWarningStat& warning : wheel.d->warning) warning.number = 0;
  }
  EXPECT_THAT(testing::internal::GetCapturedStderr(),
              HasSubstr("softsoil: wheel \"wheel\": the wheel is more than 1000000 m from the "
                        "origin; no soil forces while that lasts"));
}

// The ground bears at any depth, as a plane does.
TEST(WheelThrownAnywhere, FarBelowTheGroundIsPushedUpAgain) {
  DrivenWheel wheel;
  wheel.d->qpos[1] = -1000;
  wheel.m->opt.timestep = 0.01;
  for (int i = 0; i < 5000; ++i) wheel.Step();
  EXPECT_GT(wheel.d->qpos[1], -900);
  EXPECT_EQ(softsoil_wheel_count(wheel.d.get()), 1) << softsoil_error();
  softsoilGround ground;
  EXPECT_EQ(softsoil_ground(wheel.d.get(), &ground), 0);
  EXPECT_LT(ground.bytes, 20u << 20);
}

TEST(TimeStep, MayChangeBetweenSteps) {
  DrivenWheel wheel;
  const double from = wheel.d->qpos[0];
  for (int i = 0; i < 100; ++i) {
    wheel.m->opt.timestep = i % 3 == 0 ? 0.0004 : i % 3 == 1 ? 0.002 : 0.0011;
    wheel.Step();
  }
  EXPECT_EQ(softsoil_wheel_count(wheel.d.get()), 1);
  EXPECT_LT(wheel.Height((from + wheel.d->qpos[0]) / 2), -0.005) << "the rut goes on";
}

TEST(TimeStep, InTwoPartsIsOne) {
  DrivenWheel wheel;
  const std::uint64_t plain = wheel.Future(kFuture);
  wheel.PutBack();
  for (int i = 0; i < 50; ++i) {
    mj_step1(wheel.m.get(), wheel.d.get());
    mj_step2(wheel.m.get(), wheel.d.get());
  }
  EXPECT_EQ(HashOf(wheel.d.get()), plain);
}

// Steps that are none leave no trace once the mjData is put back.
TEST(TimeStep, ThatIsNoneIsRefusedAndCostsNothing) {
  for (const double h : {-0.001, kNan, kInfinity}) {
    SCOPED_TRACE(h);
    DrivenWheel wheel;
    const std::uint64_t plain = wheel.Future(kFuture);
    wheel.PutBack();
    const Heights ruts = HeightsOf(wheel.d.get());
    testing::internal::CaptureStderr();
    wheel.m->opt.timestep = h;
    for (int i = 0; i < 3; ++i) mj_forward(wheel.m.get(), wheel.d.get());
    EXPECT_THAT(testing::internal::GetCapturedStderr(),
                HasSubstr("softsoil: <option> timestep: must be >= 0 s, got"));
    EXPECT_EQ(HeightsOf(wheel.d.get()), ruts);
    EXPECT_EQ(wheel.Row()[2], 0);
    wheel.m->opt.timestep = 0.001;
    wheel.Run(kFuture);
    EXPECT_EQ(HashOf(wheel.d.get()), plain);
  }
}

TEST(TimeStep, OfZeroOnlyAsks) {
  DrivenWheel wheel;
  const std::uint64_t plain = wheel.Future(kFuture);
  wheel.PutBack();
  wheel.m->opt.timestep = 0;
  for (int i = 0; i < 3; ++i) wheel.Step();
  wheel.m->opt.timestep = 0.001;
  wheel.Run(kFuture);
  EXPECT_EQ(HashOf(wheel.d.get()), plain);
}

}  // namespace
}  // namespace softsoil
