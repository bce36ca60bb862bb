#include "plugin/ground_plane.h"

#include <gmock/gmock.h>

#include <cmath>

#include "terrain/input_error.h"
#include "tests/plugin/mjcf.h"

namespace softsoil {
namespace {

using testing::HasSubstr;

std::string Refusal(const std::string& bodies, const std::string& name = "") {
  try {
    FindGroundPlane(Load(World(bodies)).get(), name);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(GroundPlane, IsTheOnlyPlaneOfTheWorld) {
  const Model m = Load(World(R"(<geom size="1"/><geom type="plane" pos="0 0 .5" size="1 1 1"/>)"));
  const GroundPlane ground = FindGroundPlane(m.get(), "");
  EXPECT_EQ(ground.geom, 1);
  EXPECT_EQ(ground.height(3, -4), 0.5);
}

TEST(GroundPlane, MayBeInclinedAndBelongToAFixedBody) {
  const Model m = Load(World(
      R"(<body pos="1 2 3" euler="0 0 90">
           <geom type="plane" euler="0 -10 0" size="1 1 1"/></body>)"));
  const GroundPlane ground = FindGroundPlane(m.get(), "");
  const double slope = std::tan(10 * 3.14159265358979 / 180);
  EXPECT_NEAR(ground.height(1, 2), 3, 1e-9);
  EXPECT_NEAR(ground.height(5, 2), 3, 1e-9);
  EXPECT_NEAR(ground.height(1, 3), 3 + slope, 1e-9);
}

TEST(GroundPlane, IsRefusedWithItsName) {
  EXPECT_EQ(Refusal(R"(<geom size="1"/>)"), "no ground: the world must have a geom of type plane");
  EXPECT_THAT(Refusal(R"(<geom name="a" type="plane" size="1 1 1"/>
                         <geom type="plane" size="1 1 1"/>)"),
              HasSubstr("Name one of geom \"a\", geom 1 in <custom> <text name="));
  EXPECT_EQ(Refusal(R"(<geom name="a" type="box" size="1 1 1"/>)", "a"),
            "softsoil_ground: geom \"a\" must be of type plane and fixed to the world");
  EXPECT_EQ(Refusal(R"(<geom name="a" type="plane" size="1 1 1" euler="61 0 0"/>)"),
            "the ground, geom \"a\", must be at most 60 degrees from level, got 61");
}

}  // namespace
}  // namespace softsoil
