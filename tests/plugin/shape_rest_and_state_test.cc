// Light bodies with surfaces of their own come to rest, and their soil is state like any other.
#include <gmock/gmock.h>
#include <unistd.h>

#include <cstdio>
#include <string>

#include "plugin/softsoil.h"
#include "tests/plugin/mjcf.h"

namespace softsoil {
namespace {

// A world of soft sand. `others`: attributes of <option>.
std::string Sand(const std::string& bodies, const std::string& shapes, const std::string& option) {
  return "<mujoco><option " + option + R"(/><custom>
      <text name="softsoil_soil" data="dry_sand"/><numeric name="softsoil_volumes" data="10"/>
      <numeric name="softsoil_grid_spacing" data="0.02"/>
      <text name="softsoil_shapes" data=")" +
         shapes + R"("/></custom><worldbody>
      <geom name="field" type="plane" size="9 9 1" contype="2" conaffinity="0"/>)" +
         bodies + "</worldbody></mujoco>";
}

// 10 kg that are dropped from a centimetre above the ground, free to slide and tilt.
constexpr char kShoe[] = R"(<body pos="0 0 .03"><freejoint/>
    <geom name="shoe" type="box" size=".1 .08 .02" mass="10"/></body>)";

struct OnSand {
  Model m;
  Data d;

  explicit OnSand(const std::string& mjcf, const char* settings = "sync=1")
      : m(Load(mjcf)), d(MakeData(m)) {
    EXPECT_EQ(softsoil_attach(m.get(), d.get(), settings), 0) << softsoil_error();
  }
  ~OnSand() { ExpectNoWarnings(d); }
  void Run(double seconds) {
    for (const double end = d->time + seconds; d->time < end - 1e-9;) mj_step(m.get(), d.get());
  }
  softsoilWheel Wheel(int number = 0) const {
    softsoilWheel wheel = {};
    EXPECT_EQ(softsoil_wheel(d.get(), number, &wheel), 0) << softsoil_error();
    return wheel;
  }
  std::uint64_t Hash() const {
    std::uint64_t hash = 0;
    EXPECT_EQ(softsoil_hash(d.get(), &hash), 0) << softsoil_error();
    return hash;
  }
};

class LightShoe : public testing::TestWithParam<const char*> {};

TEST_P(LightShoe, ComesToRestWithoutJitter) {
  OnSand sand(Sand(kShoe, "shoe", GetParam()));
  sand.Run(0.6);
  const double x = sand.d->qpos[0], z = sand.d->qpos[2];
  EXPECT_LT(z, 0.018);  // it has sunk in
  for (int k = 0; k < 50; ++k) {
    mj_step(sand.m.get(), sand.d.get());
    EXPECT_NEAR(sand.Wheel().load / (10 * 9.81), 1, 0.01);
    EXPECT_NEAR(sand.d->qpos[2], z, 2e-6);
    EXPECT_NEAR(sand.d->qpos[0], x, 2e-6);
  }
}

INSTANTIATE_TEST_SUITE_P(TimeSteps, LightShoe,
                         testing::Values("timestep=\"0.001\"", "timestep=\"0.002\""));

// A vehicle too heavy for its wheels rests on its belly as well.
TEST(Belly, CarriesWhatTheWheelsDoNot) {
  std::string wheels;
  for (const char* place : {".2 .2", ".2 -.2", "-.2 .2", "-.2 -.2"}) {
    wheels += std::string("<body pos=\"") + place + R"( -.07"><joint axis="0 1 0"/>
        <geom type="cylinder" zaxis="0 1 0" size=".1 .03" mass=".5" conaffinity="0"/></body>)";
  }
  OnSand sand(Sand(R"(<body name="chassis" pos="0 0 .15"><joint type="slide" axis="0 0 1"/>
      <geom name="belly" type="box" size=".25 .15 .1" mass="400" conaffinity="0"/>)" +
                       wheels + "</body>",
                   "belly", "timestep=\"0.002\""));
  sand.Run(0.5);
  double loads = 0, belly = 0;
  ASSERT_EQ(softsoil_wheel_count(sand.d.get()), 5);
  for (int k = 0; k < 5; ++k) {
    loads += sand.Wheel(k).load;
    if (std::string(sand.Wheel(k).name) == "chassis") belly = sand.Wheel(k).load;
  }
  EXPECT_NEAR(loads / (402 * 9.81), 1, 0.02);
  EXPECT_GT(belly / loads, 0.1);
}

// The shoe slides in, so that its edges have pushed soil: state besides the ground's.
std::string Sliding() { return Sand(kShoe, "shoe", R"(timestep="0.002")"); }

TEST(ShapeState, HasTheSameBitsOnAnyNumberOfThreads) {
  OnSand one(Sliding(), "threads=1"), two(Sliding(), "threads=2");
  for (OnSand* sand : {&one, &two}) {
    sand->d->qvel[0] = 0.5;
    sand->Run(0.3);
  }
  EXPECT_GT(one.d->qpos[0], 0.02);
  EXPECT_EQ(one.Hash(), two.Hash());
  for (int k = 0; k < one.m->nq; ++k) EXPECT_EQ(one.d->qpos[k], two.d->qpos[k]);
}

TEST(ShapeState, GoesOnAlikeFromAFileAndInACopy) {
  const std::string path = testing::TempDir() + "softsoil_shape_" + std::to_string(getpid());
  OnSand a(Sliding());
  a.d->qvel[0] = 0.5;
  a.Run(0.1);
  ASSERT_EQ(softsoil_save_simulation(a.m.get(), a.d.get(), path.c_str()), 0) << softsoil_error();
  OnSand loaded(Sliding()), copy(Sliding());
  ASSERT_EQ(softsoil_load_simulation(loaded.m.get(), loaded.d.get(), path.c_str()), 0)
      << softsoil_error();
  std::remove(path.c_str());
  mj_copyData(copy.d.get(), copy.m.get(), a.d.get());
  ASSERT_EQ(softsoil_copy(copy.d.get(), a.d.get()), 0) << softsoil_error();
  const std::uint64_t before = a.Hash();
  for (OnSand* sand : {&a, &loaded, &copy}) {
    EXPECT_EQ(sand->Hash(), before);
    sand->Run(0.2);
  }
  EXPECT_NE(a.Hash(), before);
  for (const OnSand* other : {&loaded, &copy}) {
    EXPECT_EQ(other->Hash(), a.Hash());
    for (int k = 0; k < a.m->nq; ++k) EXPECT_EQ(other->d->qpos[k], a.d->qpos[k]);
  }
}

TEST(ShapeState, IsRefusedForAnotherMesh) {
  const std::string path = testing::TempDir() + "softsoil_shape_" + std::to_string(getpid());
  OnSand a(Sliding());
  ASSERT_EQ(softsoil_save_simulation(a.m.get(), a.d.get(), path.c_str()), 0) << softsoil_error();
  std::string other = Sliding();
  other.replace(other.find("size=\".1 .08 .02\""), 17, "size=\".1 .08 .01\"");
  OnSand b(other);
  EXPECT_NE(softsoil_load_simulation(b.m.get(), b.d.get(), path.c_str()), 0);
  EXPECT_THAT(softsoil_error(), testing::HasSubstr("the state is of another soil: "));
  EXPECT_THAT(softsoil_error(), testing::HasSubstr(" mesh is "));
  std::remove(path.c_str());
}

}  // namespace
}  // namespace softsoil
