#include "plugin/wheel_finder.h"

#include <gmock/gmock.h>

#include "plugin/model_geometry.h"
#include "terrain/input_error.h"
#include "tests/plugin/mjcf.h"

namespace softsoil {
namespace {

using Eigen::Vector3d;
using testing::ElementsAre;
using testing::HasSubstr;

std::vector<Wheel> Find(const std::string& bodies, const std::vector<std::string>& named = {}) {
  return FindWheels(Load(World(bodies)).get(), named);
}

std::string Refusal(const std::string& bodies, const std::vector<std::string>& named) {
  try {
    Find(bodies, named);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

std::vector<std::string> Names(const std::vector<Wheel>& wheels) {
  std::vector<std::string> names;
  for (const Wheel& wheel : wheels) names.push_back(wheel.name);
  return names;
}

// A chassis that faces along x, with `wheels` as its children.
std::string Car(const std::string& wheels) {
  return R"(<body name="car"><freejoint/><geom type="box" size="1 .5 .2"/>)" + wheels + "</body>";
}

Vector3d AxisInWorld(const std::string& mjcf) {
  const Model m = Load(World(mjcf));
  const std::vector<Wheel> wheels = FindWheels(m.get(), {});
  EXPECT_EQ(wheels.size(), 1u);
  return PoseAtStart(m.get(), wheels[0].body, 0).orientation * wheels[0].axis_b;
}

TEST(WheelFinder, FindsACylinderAcrossTheVehicle) {
  const auto wheels = Find(Car(R"(<body name="w" pos="1 .7 0"><joint axis="0 1 0"/>
      <geom type="cylinder" zaxis="0 1 0" size=".4 .1"/></body>)"));
  ASSERT_THAT(Names(wheels), ElementsAre("w"));
  EXPECT_NEAR(wheels[0].radius, 0.4, 1e-12);
  EXPECT_NEAR(wheels[0].half_width, 0.1, 1e-12);
  EXPECT_NEAR((wheels[0].axis_b - Vector3d(0, 1, 0)).norm(), 0, 1e-12);
  EXPECT_NEAR(wheels[0].centre_b.norm(), 0, 1e-12);
}

TEST(WheelFinder, PointsTheAxisToTheLeftWhateverTheSignOfTheHinge) {
  for (const char* axis : {"0 1 0", "0 -1 0"}) {
    const std::string wheel = R"(<body><joint axis=")" + std::string(axis) + R"("/>
        <geom type="cylinder" zaxis="0 1 0" size=".4 .1"/></body>)";
    EXPECT_NEAR((AxisInWorld(Car(wheel)) - Vector3d(0, 1, 0)).norm(), 0, 1e-12);
  }
}

TEST(WheelFinder, KnowsTheLeftOfAVehicleThatFacesElsewhere) {
  const std::string facing_y = R"(<body euler="0 0 90"><freejoint/><geom type="box" size="1 1 1"/>
      <body><joint axis="0 1 0"/><geom type="cylinder" zaxis="0 1 0" size=".4 .1"/></body></body>)";
  EXPECT_NEAR((AxisInWorld(facing_y) - Vector3d(-1, 0, 0)).norm(), 0, 1e-12);
}

TEST(WheelFinder, TakesAVehicleWithAxlesAlongXToFaceAlongY) {
  const std::string wheel = R"(<body><joint axis="1 0 0"/>
      <geom type="cylinder" zaxis="1 0 0" size=".4 .1"/></body>)";
  EXPECT_NEAR((AxisInWorld(Car(wheel)) - Vector3d(-1, 0, 0)).norm(), 0, 1e-12);
}

TEST(WheelFinder, FollowsRotatedFramesWithTheHingeAlongLocalZ) {
  const std::string wheel = R"(<body euler="90 0 0"><body euler="0 0 30"><joint axis="0 0 1"/>
      <geom type="cylinder" size=".4 .1"/></body></body>)";
  EXPECT_NEAR((AxisInWorld(Car(wheel)) - Vector3d(0, 1, 0)).norm(), 0, 1e-9);
}

TEST(WheelFinder, PrefersTheCollidingGeomToItsVisualDuplicate) {
  const auto wheels = Find(Car(R"(<body name="w"><joint axis="0 1 0"/>
      <geom type="cylinder" zaxis="0 1 0" size=".45 .1" contype="0" conaffinity="0"/>
      <geom type="cylinder" zaxis="0 1 0" size=".4 .1"/></body>)"));
  ASSERT_EQ(wheels.size(), 1u);
  EXPECT_NEAR(wheels[0].radius, 0.4, 1e-12);
}

TEST(WheelFinder, PrefersTheTireToTheHub) {
  const auto wheels = Find(Car(R"(<body name="w"><joint axis="0 1 0"/>
      <geom type="cylinder" zaxis="0 1 0" size=".1 .2"/>
      <geom type="cylinder" zaxis="0 1 0" size=".4 .1"/></body>)"));
  ASSERT_EQ(wheels.size(), 1u);
  EXPECT_NEAR(wheels[0].radius, 0.4, 1e-12);
}

TEST(WheelFinder, PutsTheCentreOfAnOffsetGeomOnTheHinge) {
  const auto wheels = Find(Car(R"(<body name="w"><joint axis="0 1 0" pos=".01 0 0"/>
      <geom type="cylinder" zaxis="0 1 0" pos="0 .3 0" size=".4 .1"/></body>)"));
  ASSERT_EQ(wheels.size(), 1u);
  EXPECT_NEAR((wheels[0].centre_b - Vector3d(0.01, 0.3, 0)).norm(), 0, 1e-12);
}

TEST(WheelFinder, TellsSpinFromSteeringOnOneBody) {
  const Model m = Load(World(Car(R"(<body name="w"><joint name="steer" axis="0 0 1"/>
      <joint name="spin" axis="0 1 0"/>
      <geom type="cylinder" zaxis="0 1 0" size=".4 .1"/></body>)")));
  const auto wheels = FindWheels(m.get(), {});
  ASSERT_EQ(wheels.size(), 1u);
  EXPECT_EQ(wheels[0].joint, mj_name2id(m.get(), mjOBJ_JOINT, "spin"));
}

TEST(WheelFinder, FindsJointlessWheelsThatTurnWithAnAxle) {
  const auto wheels = Find(Car(R"(<body name="axle"><joint axis="0 1 0"/>
      <geom type="cylinder" zaxis="0 1 0" size=".05 .8"/>
      <body name="left" pos="0 .8 0"><geom type="cylinder" zaxis="0 1 0" size=".4 .1"/></body>
      <body name="right" pos="0 -.8 0"><geom type="cylinder" zaxis="0 1 0" size=".4 .1"/></body>
      </body>)"));
  EXPECT_THAT(Names(wheels), ElementsAre("left", "right"));
  EXPECT_NEAR(wheels[0].centre_b.norm(), 0, 1e-12);
}

TEST(WheelFinder, TakesCapsuleEllipsoidAndSphere) {
  const auto wheels = Find(Car(R"(
      <body name="capsule"><joint axis="0 1 0"/>
        <geom type="capsule" zaxis="0 1 0" size=".4 .01"/></body>
      <body name="ellipsoid"><joint axis="0 1 0"/><geom type="ellipsoid" size=".4 .1 .4"/></body>
      <body name="caster"><joint axis="0 0 1"/><joint axis="0 1 0"/>
        <geom type="sphere" size=".1"/></body>)"));
  ASSERT_THAT(Names(wheels), ElementsAre("capsule", "ellipsoid", "caster"));
  EXPECT_EQ(wheels[1].outline, WheelOutline::kEllipsoid);
  EXPECT_NEAR(wheels[1].half_width, 0.1, 1e-12);
  EXPECT_NEAR(std::abs(wheels[2].axis_b.y()), 1, 1e-12);
}

TEST(WheelFinder, DoesNotTakeArmsDoorsTurretsOrBalls) {
  EXPECT_THAT(Refusal(Car(R"(
      <body name="limited"><joint axis="0 1 0" limited="true" range="-90 90"/>
        <geom type="cylinder" zaxis="0 1 0" size=".4 .1"/></body>
      <body name="turret"><joint axis="0 0 1"/><geom type="cylinder" size=".4 .1"/></body>
      <body name="tilted"><joint axis="0 1 .05"/>
        <geom type="cylinder" zaxis="0 1 0" size=".4 .1"/></body>
      <body name="crank"><joint axis="0 1 0" pos=".03 0 0"/>
        <geom type="cylinder" zaxis="0 1 0" size=".4 .1"/></body>
      <body name="bone"><joint axis="0 1 0"/><geom type="ellipsoid" size=".4 .1 .2"/></body>
      <body name="slider"><joint type="slide" axis="0 1 0"/>
        <geom type="cylinder" zaxis="0 1 0" size=".4 .1"/></body>
      <body name="ball"><joint type="ball"/><geom type="sphere" size=".1"/></body>)"),
                      {}),
              HasSubstr("no wheels found: the model must have a body with a cylinder"))
      << "crank: 0.03 m is 7.5 % of the radius";
}

TEST(WheelFinder, TakesOnlyNamedBodies) {
  const std::string car = Car(R"(
      <body name="a"><joint axis="0 1 0"/><geom type="sphere" size=".4"/></body>
      <body name="b"><joint axis="0 1 0"/><geom type="sphere" size=".4"/></body>)");
  EXPECT_THAT(Names(Find(car)), ElementsAre("a", "b"));
  EXPECT_THAT(Names(Find(car, {"b"})), ElementsAre("b"));
}

TEST(WheelFinder, TakesAMeshIfItIsNamed) {
  const Model m =
      Load(World(Car(R"(<body name="w"><joint axis="0 1 0"/>
      <geom type="mesh" mesh="tetra"/></body>)"),
                 R"(<asset><mesh name="tetra" vertex="0 0 0 1 0 0 0 1 0 0 0 1"/></asset>)"));
  EXPECT_THROW(FindWheels(m.get(), {}), InputError);
  const auto wheels = FindWheels(m.get(), {"w"});
  ASSERT_EQ(wheels.size(), 1u);
  EXPECT_EQ(wheels[0].outline, WheelOutline::kUnknown);
}

TEST(WheelFinder, RefusesNamedBodiesThatAreNoWheels) {
  const std::string car = Car(R"(<body name="fixed"><geom size=".4"/></body>
      <body name="box"><joint axis="0 1 0"/><geom type="box" size=".4 .4 .4"/></body>
      <body name="bare"><joint axis="0 1 0"/>
        <inertial pos="0 0 0" mass="1" diaginertia="1 1 1"/></body>
      <body name="good"><joint axis="0 1 0"/><geom size=".4"/></body>)");
  EXPECT_THAT(Refusal(car, {"fixed"}),
              HasSubstr("softsoil_wheels: body \"fixed\" has no spin axis: it must turn about"));
  EXPECT_THAT(Refusal(car, {"box"}),
              HasSubstr("softsoil_wheels: body \"box\" has no geom round about its hinge"));
  EXPECT_THAT(Refusal(car, {"bare"}),
              HasSubstr("softsoil_wheels: body \"bare\" has no geom round about its hinge"));
  EXPECT_EQ(Refusal(car, {"none"}), "softsoil_wheels: the model has no body \"none\"");
  EXPECT_EQ(Refusal(car, {"good", "good"}), "softsoil_wheels: body \"good\" is named twice");
}

}  // namespace
}  // namespace softsoil
