#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "tests/plugin/simulation.h"

namespace softsoil {
namespace {

using testing::HasSubstr;

TEST(CApi, GivesNamesAndResults) {
  OneWheel narrow;
  narrow.wheel_geom = R"(type="cylinder" zaxis="0 1 0" size=".4 .02")";
  Simulation sim(narrow);
  sim.Run(1);
  EXPECT_STREQ(softsoil_version(), SOFTSOIL_VERSION);
  EXPECT_EQ(softsoil_wheel_count(sim.d.get()), 1);
  const softsoilWheel wheel = sim.Wheel();
  EXPECT_STREQ(wheel.name, "wheel");
  EXPECT_EQ(wheel.body, sim.WheelBody());
  EXPECT_GT(wheel.contact_area, 0);
  EXPECT_GE(wheel.peak_pressure, wheel.mean_pressure);
  EXPECT_NEAR(wheel.force[2], wheel.load, 1e-9);
  EXPECT_NEAR(wheel.centre[2], sim.d->xpos[3 * wheel.body + 2], 1e-3);
  EXPECT_GT(wheel.compaction_energy, 0);

  softsoilGround ground;
  ASSERT_EQ(softsoil_ground(sim.d.get(), &ground), 0);
  EXPECT_STREQ(ground.soil, "tilled_yolo_loam");
  EXPECT_EQ(ground.grid_spacing, 0.025);
  EXPECT_GT(ground.columns, 0u);
  EXPECT_EQ(ground.volumes, 30 * ground.columns);
  EXPECT_GT(ground.rut_volume, 0);
  EXPECT_STREQ(ground.stress, "direct");
  EXPECT_GT(ground.direct_updates, 0u);
  EXPECT_EQ(ground.gaussian_updates, 0u);

  softsoilProfile early, late;
  ASSERT_EQ(softsoil_profile(sim.d.get(), &early), 0);
  EXPECT_GT(early.contact, 0);
  EXPECT_GT(early.stress, 0);
  EXPECT_GT(early.compaction, 0);
  for (int step = 0; step < 10; ++step) mj_step(sim.m.get(), sim.d.get());
  ASSERT_EQ(softsoil_profile(sim.d.get(), &late), 0);
  EXPECT_GT(late.contact, early.contact);

  double lowest = 0;
  softsoil_visit_surface(
      sim.d.get(),
      [](void* user, double, double, double height, double sinkage) {
        auto* lowest = static_cast<double*>(user);
        *lowest = std::min(*lowest, height);
        EXPECT_NEAR(height, -sinkage, 1e-12);
      },
      &lowest);
  EXPECT_LE(lowest, sim.Height());
  EXPECT_LT(lowest, 0);
}

void ExpectAtRest(const softsoilWheel& wheel) {
  for (const double value :
       {wheel.load, wheel.sinkage, wheel.rut_depth, wheel.slip_ratio, wheel.spin,
        wheel.forward_speed, wheel.thrust, wheel.torque, wheel.contact_area, wheel.mean_pressure,
        wheel.peak_pressure, wheel.compaction_energy, wheel.centre[2], wheel.force[2]}) {
    EXPECT_EQ(value, 0);
  }
}

TEST(CApi, ResetsToWhatAttachingGives) {
  Simulation sim{OneWheel{}};
  sim.d->qvel[0] = 1;
  sim.Row()[0] = 100;
  const auto drive = [&sim] {
    sim.Run(0.5);
    return std::make_pair(sim.d->qpos[0], sim.d->qpos[1]);
  };
  const auto first = drive();
  ASSERT_LT(sim.Height(0.2), 0);
  ASSERT_EQ(softsoil_reset(sim.m.get(), sim.d.get()), 0);
  EXPECT_EQ(sim.Height(0.2), 0);
  ExpectAtRest(sim.Wheel());
  EXPECT_EQ(sim.Row()[0], 100) << "the host's part stays";
  for (int k = 1; k < 6; ++k) EXPECT_EQ(sim.Row()[k], 0) << k;

  mj_resetData(sim.m.get(), sim.d.get());
  sim.d->qvel[0] = 1;
  sim.Row()[0] = 100;
  EXPECT_EQ(drive(), first);
}

TEST(CApi, ResetsOnlyTheModelThatTheSoilWasMadeFor) {
  Simulation sim{OneWheel{}};
  OneWheel another;
  another.custom = "";
  const Model m = Load(another.Mjcf());
  EXPECT_EQ(softsoil_reset(m.get(), sim.d.get()), -1);
  EXPECT_STREQ(softsoil_error(),
               "this mjData has no soil for this mjModel: call softsoil_attach() first");
}

TEST(CApi, TellsHeightsWithinAThousandKilometres) {
  const Simulation sim{OneWheel{}};
  double height = 1;
  EXPECT_EQ(softsoil_height(sim.d.get(), 1e6, -1e6, &height), 0);
  EXPECT_EQ(height, 0);
  EXPECT_EQ(softsoil_height(sim.d.get(), std::nan(""), 0, &height), -1);
  EXPECT_STREQ(softsoil_error(), "x must be -1000000 to 1000000 m, got nan");
  EXPECT_EQ(softsoil_height(sim.d.get(), 0, -INFINITY, &height), -1);
  EXPECT_STREQ(softsoil_error(), "y must be -1000000 to 1000000 m, got -inf");
  EXPECT_EQ(softsoil_height(sim.d.get(), 0, 1000001, &height), -1);
  EXPECT_STREQ(softsoil_error(), "y must be -1000000 to 1000000 m, got 1000001");
}

TEST(CApi, GivesZerosBeforeTheFirstStep) {
  const Simulation sim{OneWheel{}};
  const softsoilWheel wheel = sim.Wheel();
  EXPECT_EQ(wheel.load, 0);
  EXPECT_EQ(wheel.slip_ratio, 0);
  EXPECT_EQ(wheel.contact_area, 0);
  EXPECT_EQ(wheel.mean_pressure, 0);
}

TEST(CApi, RefusesBadArguments) {
  Simulation sim{OneWheel{}};
  softsoilWheel wheel;
  EXPECT_EQ(softsoil_wheel(sim.d.get(), 1, &wheel), -1);
  EXPECT_STREQ(softsoil_error(), "wheel must be 0 to 0, got 1");
  EXPECT_EQ(softsoil_wheel(sim.d.get(), 0, nullptr), -1);
  EXPECT_STREQ(softsoil_error(), "result must not be NULL");
  EXPECT_EQ(softsoil_attach(nullptr, sim.d.get(), nullptr), -1);
  EXPECT_STREQ(softsoil_error(), "mjModel must not be NULL");
  const Data other = MakeData(sim.m);
  EXPECT_EQ(softsoil_wheel(other.get(), 0, &wheel), -1);
  EXPECT_STREQ(softsoil_error(), "this mjData has no soil: call softsoil_attach() first");
}

std::string AttachRefusal(const OneWheel& model, const char* settings = nullptr) {
  const Model m = Load(model.Mjcf());
  const Data d = MakeData(m);
  EXPECT_EQ(softsoil_attach(m.get(), d.get(), settings), -1);
  const std::string error = softsoil_error();
  EXPECT_EQ(softsoil_wheel_count(d.get()), -1);
  return error;
}

TEST(Attach, RefusesWhatItCannotDoWithAClearSentence) {
  const OneWheel good;
  EXPECT_THAT(AttachRefusal(good, "soil=moon"),
              HasSubstr("softsoil_soil: unknown soil \"moon\"; known are: "));
  EXPECT_THAT(AttachRefusal(good, "tire=moon"),
              HasSubstr("softsoil_tire: unknown tire \"moon\"; known are: 18.4R38_85kPa"));
  EXPECT_THAT(AttachRefusal(good, "tire=hub=auto"),
              HasSubstr("softsoil_tire: \"hub\" is no wheel; wheels are: wheel"));
  EXPECT_THAT(AttachRefusal(good, "wheels=hub"), HasSubstr("body \"hub\" has no spin axis"));
  EXPECT_THAT(AttachRefusal(good, "ground=tread"),
              HasSubstr("softsoil_ground: geom \"tread\" must be of type plane"));
  EXPECT_THAT(AttachRefusal(good, "ground=moon"),
              HasSubstr("softsoil_ground: the model has no geom \"moon\""));
  EXPECT_THAT(AttachRefusal(good, "soil_file=nowhere.xml"), HasSubstr("nowhere.xml"));
  EXPECT_THAT(AttachRefusal(good, "clock=-1"), HasSubstr("clock: must be 0.0001 to 10 s, got -1"));

  OneWheel model = good;
  model.custom = "";
  EXPECT_THAT(AttachRefusal(model),
              HasSubstr("softsoil_soil: the model or the settings must name a soil"));
  model = good;
  model.plane += R"(euler="70 0 0")";
  EXPECT_THAT(AttachRefusal(model), HasSubstr("must be at most 60 degrees from level, got 70"));
  model = good;
  model.option = R"(gravity="1 0 -9")";
  EXPECT_EQ(AttachRefusal(model), "<option> gravity: must act along -z, got 1 0 -9");
}

TEST(Attach, RefusesOptionsUnderWhichSoilCannotAct) {
  OneWheel passive;
  passive.others = R"(<option><flag passive="disable"/></option>)";
  EXPECT_THAT(AttachRefusal(passive), HasSubstr("<flag passive>: must be \"enable\""));
  OneWheel frozen;
  frozen.timestep = "0";
  EXPECT_EQ(AttachRefusal(frozen), "<option> timestep: must be > 0 s, got 0");
}

TEST(Attach, RefusesListsThatNameNothing) {
  OneWheel model;
  model.custom += R"(<text name="softsoil_tire" data=" , "/>)";
  EXPECT_EQ(AttachRefusal(model), "<custom> softsoil_tire: must name something, got \" , \"");
}

TEST(Attach, RefusesAnAxleThatPassesForAWheel) {
  OneWheel axle;
  axle.wheel_geom = R"(type="cylinder" zaxis="0 1 0" size=".05 1")";
  EXPECT_THAT(AttachRefusal(axle), HasSubstr("has the half width 1 m, more than 5 times its"));
}

TEST(Attach, RefusesNumbersBeforeItSaysAnything) {
  OneWheel model;
  model.wheel_geom = R"(type="sphere" size=".33")";  // said nowhere else
  testing::internal::CaptureStderr();
  EXPECT_THAT(AttachRefusal(model, "grid_spacing=0.0005"),
              HasSubstr("grid_spacing: must be 0.001 to 10 m, got 0.0005"));
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

}  // namespace
}  // namespace softsoil
