#include "plugin/shapes.h"

#include <gmock/gmock.h>

#include "plugin/soil_plan.h"
#include "terrain/input_error.h"
#include "tests/contact/mesh_samples.h"
#include "tests/plugin/simulation.h"

namespace softsoil {
namespace {

using testing::HasSubstr;

const GrouserWheel kWheel = {0.3, 0.2, 0.02, 0.01, 24, 3};

// <asset> with the mesh under the name "tread".
std::string Asset(const TriangleMesh& mesh) {
  std::string vertices, faces;
  for (const Eigen::Vector3d& v : mesh.vertices) {
    for (int k = 0; k < 3; ++k) vertices += std::to_string(v[k]) + " ";
  }
  for (const std::array<int, 3>& corners : mesh.triangles) {
    for (const int corner : corners) faces += std::to_string(corner) + " ";
  }
  return "<asset><mesh name=\"tread\" vertex=\"" + vertices + "\" face=\"" + faces + "\"/></asset>";
}

OneWheel Rover(const std::string& more = "") {
  OneWheel model;
  model.custom += R"(<text name="softsoil_shapes" data="tread"/>)" + more;
  model.wheel_geom = R"(type="mesh" mesh="tread" pos="0 .05 0")";
  model.others = Asset(kWheel.Mesh());
  return model;
}

// A plate on a vertical slide.
std::string Plate(const std::string& shapes, const std::string& more = "") {
  return R"(<mujoco><option timestep="0.001"/><custom>
      <text name="softsoil_soil" data="tilled_yolo_loam"/>
      <text name="softsoil_shapes" data=")" +
         shapes + R"("/><numeric name="softsoil_sync" data="1"/></custom><worldbody>
      <geom name="field" type="plane" size="9 9 1" contype="0" conaffinity="0"/>
      <geom name="wall" type="box" size="1 1 1" pos="9 9 0" contype="0" conaffinity="0"/>
      <body name="plate" pos="0 0 .05"><joint type="slide" axis="0 0 1"/>
        <geom name="shoe" type="box" size=".2 .15 .05" mass="200"/>
        <geom name="knob" type="sphere" size=".02" mass="0"/>)" +
         more + "</body></worldbody></mujoco>";
}

SoilPlan PlanOf(const std::string& mjcf) {
  const Model m = Load(mjcf);
  return MakePlan(m.get(), SettingsOf(m.get()));
}

std::string Refusal(const std::string& shapes, const std::string& more = "") {
  try {
    PlanOf(Plate(shapes, more));
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Shapes, AreRigidWheelsThatTurn) {
  const SoilPlan plan = PlanOf(Rover().Mjcf());
  ASSERT_EQ(plan.wheels.size(), 1u);
  const Wheel& wheel = plan.wheels[0];
  EXPECT_EQ(wheel.name, "wheel");
  EXPECT_GE(wheel.joint, 0);
  EXPECT_NEAR(wheel.radius, std::hypot(0.32, 0.005), 1e-5);
  EXPECT_NEAR(wheel.half_width, 0.1, 1e-6);
  EXPECT_NEAR((wheel.centre_b - Eigen::Vector3d(0, 0.05, 0)).norm(), 0, 1e-5);
  EXPECT_EQ(plan.tires[0].name, kRigidTire);
  EXPECT_NEAR(Volume(*plan.tires[0].mesh), kWheel.PolygonArea() * kWheel.width, 1e-6);
}

TEST(Shapes, MayHaveTheSpringOfATire) {
  const SoilPlan plan =
      PlanOf(Rover(R"(<text name="softsoil_tire" data="37x12.5R16.5_15psi"/>)").Mjcf());
  EXPECT_EQ(plan.tires[0].name, "37x12.5R16.5_15psi");
  EXPECT_NE(plan.tires[0].mesh, nullptr);
  EXPECT_NEAR(plan.tires[0].shape.radius, 0.32, 1e-3);
}

TEST(Shapes, MayBeBodiesThatDoNotTurn) {
  const SoilPlan plan = PlanOf(Plate("shoe"));
  ASSERT_EQ(plan.wheels.size(), 1u);
  EXPECT_EQ(plan.wheels[0].joint, -1);
  EXPECT_NEAR(plan.tires[0].shape.width, 0.3, 1e-12);
  EXPECT_NEAR(plan.tires[0].spring.linear, 3 * 200 / 1e-6 / 4 / 0.12, 1e3);
}

TEST(Shapes, CarryTheirWeightAndComeToRestInTheirPrint) {
  const Model m = Load(Plate("shoe"));
  const Data d = MakeData(m);
  ASSERT_EQ(softsoil_attach(m.get(), d.get(), nullptr), 0) << softsoil_error();
  while (d->time < 1) mj_step(m.get(), d.get());
  const double settled = d->qpos[0];
  double load = 0;
  for (int k = 0; k < 200; ++k) {
    mj_step(m.get(), d.get());
    softsoilWheel wheel = {};
    ASSERT_EQ(softsoil_wheel(d.get(), 0, &wheel), 0);
    load += wheel.load / 200;
  }
  EXPECT_NEAR(load / (200 * 9.81), 1, 0.01);
  EXPECT_LT(settled, -0.005);
  EXPECT_NEAR(d->qpos[0], settled, 1e-4);
  double height = 0;
  softsoil_height(d.get(), 0, 0, &height);
  EXPECT_NEAR(height, settled, 0.001);
  ExpectNoWarnings(d);
}

// Mean report of a wheel at 30 % slip; the same outer radius with and without grousers.
softsoilWheel Driven(double grouser_height) {
  OneWheel model = Rover();
  GrouserWheel wheel = kWheel;
  wheel.radius = 0.32 - grouser_height;
  wheel.height = grouser_height;
  model.others = Asset(wheel.Mesh());
  Simulation simulation(model);
  const mjModel* m = simulation.m.get();
  const int slide = m->jnt_dofadr[m->body_jntadr[mj_name2id(m, mjOBJ_BODY, "hub")]];
  const int spin = m->jnt_dofadr[mj_name2id(m, mjOBJ_JOINT, "spin")];
  softsoilWheel mean = {};
  simulation.Run(2, [&] {
    const bool drives = simulation.d->time > 0.5;
    simulation.d->qvel[slide] = drives ? 0.3 : 0;
    simulation.d->qvel[spin] = drives ? 0.3 / 0.32 / (1 - 0.3) : 0;
    if (simulation.d->time < 1.5) return;
    const softsoilWheel now = simulation.Wheel();
    mean.load += now.load / 500;
    mean.motion_resistance += now.motion_resistance / 500;
  });
  return mean;
}

// Soil before the flanks of the grousers pushes the wheel ahead, against what resists its motion.
TEST(Shapes, PushAheadWithTheirGrousers) {
  const softsoilWheel smooth = Driven(1e-4), lugged = Driven(0.03);
  EXPECT_NEAR(smooth.load / kOneWheelWeight, 1, 0.05);
  EXPECT_NEAR(lugged.load / kOneWheelWeight, 1, 0.05);
  EXPECT_LT(lugged.motion_resistance, smooth.motion_resistance - 0.05 * kOneWheelWeight);
}

// One tire named for all is that of the wheels, not of a belly.
TEST(Shapes, ThatAreNoWheelsAreRigidUnlessTheirTireIsNamed) {
  const auto tire_of = [](const std::string& tires) {
    OneWheel model;
    model.custom +=
        R"(<text name="softsoil_shapes" data="belly"/><text name="softsoil_tire" data=")" + tires +
        R"("/>)";
    model.others = R"(<worldbody><body name="sled" pos="3 0 1"><joint type="slide" axis="0 0 1"/>
        <geom name="belly" type="box" size=".3 .3 .1" contype="4"/></body></worldbody>)";
    const Model m = Load(model.Mjcf());
    return MakePlan(m.get(), SettingsOf(m.get())).tires.back().name;
  };
  EXPECT_EQ(tire_of("37x12.5R16.5_15psi"), kRigidTire);
  EXPECT_EQ(tire_of("37x12.5R16.5_15psi,sled=37x12.5R16.5_35psi"), "37x12.5R16.5_35psi");
}

TEST(Shapes, AreRefusedIfTheyCannotBe) {
  EXPECT_EQ(Refusal("spade"), "softsoil_shapes: the model has no geom \"spade\"");
  EXPECT_EQ(Refusal("knob"), "softsoil_shapes: geom \"knob\": must be of type mesh or box");
  EXPECT_EQ(Refusal("wall"),
            "softsoil_shapes: geom \"wall\" is fixed to the world: its body must be able to move");
  EXPECT_EQ(Refusal("shoe,shoe"), "softsoil_shapes: geom \"shoe\" is named twice");
  EXPECT_EQ(Refusal("shoe,heel", R"(<geom name="heel" type="box" size=".1 .1 .1"/>)"),
            "softsoil_shapes: body \"plate\" must have one shape, got two: geom \"shoe\" and geom "
            "\"heel\"");
}

}  // namespace
}  // namespace softsoil
