// What becomes of soil that fails during a step, and of soil that a host passes over.
#include "plugin/host.h"

#include <gmock/gmock.h>

#include <cstdlib>
#include <stdexcept>
#include <utility>

#include "tests/plugin/simulation.h"

namespace softsoil {
namespace {

using testing::HasSubstr;
using testing::Not;

// Puts soil under the wheel whose ground fails as soon as `fails` is true.
void GiveFailingSoil(Simulation& sim, const bool* fails) {
  SoilPlan plan = MakePlan(sim.m.get(), SettingsOf(sim.m.get()));
  plan.ground.height = [fails](double, double) {
    if (*fails) throw std::logic_error("the ground is gone");
    return 0.0;
  };
  GiveSoil(sim.m.get(), sim.d.get(), std::make_shared<SoilPlan>(std::move(plan)));
}

void RunUntilSoilFails(Simulation& sim) {
  bool fails = false;
  GiveFailingSoil(sim, &fails);
  sim.Run(0.2);
  fails = true;
  sim.d->qvel[0] = 1;  // onto ground that is not touched yet
  sim.Run(0.5);
}

TEST(SoilThatFailsInAStep, LeavesTheSimulationAndTellsWhy) {
  Simulation sim{OneWheel{}};
  sim.Row()[0] = 100;
  testing::internal::CaptureStderr();
  RunUntilSoilFails(sim);
  EXPECT_THAT(testing::internal::GetCapturedStderr(),
              HasSubstr("softsoil: the ground is gone; the model runs without soft soil\n"));
  EXPECT_EQ(sim.Row()[0], 100) << "the host's part stays";
  for (int k = 1; k < 6; ++k) EXPECT_EQ(sim.Row()[k], 0) << k;
  EXPECT_EQ(softsoil_wheel_count(sim.d.get()), -1);
  EXPECT_STREQ(softsoil_error(), "this mjData has lost its soil: the ground is gone");
  EXPECT_EQ(softsoil_attach(sim.m.get(), sim.d.get(), nullptr), 0);
  EXPECT_EQ(softsoil_wheel_count(sim.d.get()), 1);
}

// Each in a process of its own: LearnModels() cannot be taken back.
class PreloadedProgram : public testing::Test {
 protected:
  PreloadedProgram() { GTEST_FLAG_SET(death_test_style, "threadsafe"); }

  static void RunUntilSoilFailsAndEnd(OnError on_error) {
    LearnModels(on_error);
    Simulation sim{OneWheel{}};
    RunUntilSoilFails(sim);
    std::_Exit(softsoil_wheel_count(sim.d.get()) == -1 ? 0 : 3);
  }
};

TEST_F(PreloadedProgram, EndsWhenSoilFails) {
  EXPECT_EXIT(RunUntilSoilFailsAndEnd(OnError::kStop), testing::ExitedWithCode(EXIT_FAILURE),
              "softsoil: the ground is gone\n$");
}

TEST_F(PreloadedProgram, GoesOnWithoutTheSoilThatFailedIfSoConfigured) {
  EXPECT_EXIT(RunUntilSoilFailsAndEnd(OnError::kContinue), testing::ExitedWithCode(0),
              "softsoil: the ground is gone; the model runs without soft soil\n$");
}

mjfGeneric earlier = nullptr;

// What is said at the end of a mjData with soil, if the host sets `passive` after us.
std::string SaidAtTheEnd(mjfGeneric passive) {
  testing::internal::CaptureStderr();
  {
    Simulation sim{OneWheel{}};
    sim.Run(0.01);
    earlier = std::exchange(mjcb_passive, passive);
    sim.Run(0.01);
    sim.d.reset();
    mjcb_passive = earlier;
  }
  return testing::internal::GetCapturedStderr();
}

TEST(HostWithAPassiveCallbackOfItsOwn, IsWarnedUnlessItCallsOurs) {
  EXPECT_THAT(SaidAtTheEnd([](const mjModel* m, mjData* d) { earlier(m, d); }),
              Not(HasSubstr("mjcb_passive")));
  EXPECT_THAT(SaidAtTheEnd([](const mjModel*, mjData*) {}),
              HasSubstr("softsoil: warning: the program has set an mjcb_passive of its own, which "
                        "does not call the one that was there: steps went by without soft soil\n"));
}

}  // namespace
}  // namespace softsoil
