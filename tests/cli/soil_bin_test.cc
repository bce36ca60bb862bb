#include "plugin/cli/soil_bin.h"

#include <gmock/gmock.h>

#include <cmath>

#include "plugin/cli/simulation.h"

namespace softsoil {
namespace {

using testing::HasSubstr;

SoilBin Tractor() {
  SoilBin bin;
  bin.tire.name = "18.4R38_85kPa";
  bin.soil = "tilled_yolo_loam";
  bin.tire.shape = {0.91, 0.661, 0.467};
  bin.load = 18000;
  return bin;
}

SoilBin Small() {
  SoilBin bin = Tractor();
  bin.tire.name = "37x12.5R16.5_15psi";
  bin.tire.shape = {0.47, 10, 0.3};
  bin.load = 5000;
  return bin;
}

// The compiled model of a bin.
class Rig {
 public:
  explicit Rig(const SoilBin& bin) : simulation_("soil_bin.xml", SoilBinModel(bin)) {}

  const mjModel& m() const { return simulation_.model(); }
  int Id(mjtObj kind, const char* name) const { return mj_name2id(&m(), kind, name); }
  double Mass(const char* body) const { return m().body_mass[Id(mjOBJ_BODY, body)]; }
  double Stiffness() const { return m().jnt_stiffness[Id(mjOBJ_JOINT, "suspension")]; }
  double Damping(const char* joint) const {
    return m().dof_damping[m().jnt_dofadr[Id(mjOBJ_JOINT, joint)]];
  }

 private:
  Simulation simulation_;
};

class AnyBin : public testing::TestWithParam<SoilBin> {};

TEST_P(AnyBin, WeighsItsLoad) {
  const Rig rig(GetParam());
  const double mass = GetParam().load / 9.81;
  EXPECT_NEAR(mj_getTotalmass(&rig.m()), mass, 1e-9 * mass);
  EXPECT_NEAR(rig.Mass("sprung_mass"), 0.90 * mass, 1e-9 * mass);
  EXPECT_NEAR(rig.Mass("spindle"), 0.05 * mass, 1e-9 * mass);
  EXPECT_NEAR(rig.Mass("wheel"), 0.05 * mass, 1e-9 * mass);
}

TEST_P(AnyBin, SwingsTwiceASecondWithHalfOfCriticalDamping) {
  const Rig rig(GetParam());
  const double frequency = std::sqrt(rig.Stiffness() / rig.Mass("sprung_mass"));  // [rad/s]
  EXPECT_NEAR(frequency / (2 * M_PI), 2, 0.05);
  EXPECT_NEAR(rig.Damping("suspension") / (2 * rig.Mass("sprung_mass") * frequency), 0.5, 0.02);
}

TEST_P(AnyBin, HasAWheelOfTheTiresSizeThatTouchesTheGround) {
  const Rig rig(GetParam());
  const mjtNum* size = rig.m().geom_size + 3 * rig.Id(mjOBJ_GEOM, "wheel");
  EXPECT_NEAR(size[0], GetParam().tire.shape.radius, 1e-9);
  EXPECT_NEAR(size[1], GetParam().tire.shape.width / 2, 1e-9);
  EXPECT_NEAR(rig.m().body_pos[3 * rig.Id(mjOBJ_BODY, "sprung_mass") + 2],
              GetParam().tire.shape.radius, 1e-9);
}

// A solid cylinder of 38 in by 16 in, 6.3.1, in proportion to the tire.
TEST_P(AnyBin, HasTheInertiaOfASolidRim) {
  const Rig rig(GetParam());
  const mjtNum* inertia = rig.m().body_inertia + 3 * rig.Id(mjOBJ_BODY, "wheel");
  const double mass = rig.Mass("wheel"), rim = 0.4826 / 0.91 * GetParam().tire.shape.radius;
  const double width = 16 / 18.4 * GetParam().tire.shape.width;
  EXPECT_NEAR(inertia[1], mass * rim * rim / 2, 1e-6);
  EXPECT_NEAR(inertia[0], mass * (3 * rim * rim + width * width) / 12, 1e-6);
}

INSTANTIATE_TEST_SUITE_P(SoilBin, AnyBin, testing::Values(Tractor(), Small()),
                         [](const auto& info) { return info.index == 0 ? "tractor" : "small"; });

TEST(SoilBin, IsTheShippedSceneForItsTireAndLoad) {
  const Rig made(Tractor());
  Simulation shipped(SOFTSOIL_SOURCE_DIR "/models/scenes/soil_bin.xml");
  EXPECT_EQ(made.m().nbody, shipped.model().nbody);
  EXPECT_EQ(made.m().ngeom, shipped.model().ngeom);
  EXPECT_NEAR(mj_getTotalmass(&made.m()), mj_getTotalmass(&shipped.model()), 3);  // 1837 kg
}

TEST(SoilBin, NamesTireSoilAndSettings) {
  SoilBin bin = Tractor();
  bin.settings = {{"mode", "compaction"}, {"clock", "0.005"}};
  const std::string model = SoilBinModel(bin);
  EXPECT_THAT(model, HasSubstr(R"(<text name="softsoil_tire" data="18.4R38_85kPa"/>)"));
  EXPECT_THAT(model, HasSubstr(R"(<text name="softsoil_mode" data="compaction"/>)"));
  EXPECT_THAT(model, HasSubstr(R"(<numeric name="softsoil_clock" data="0.005"/>)"));
}

TEST(SoilBin, TouchesNothingButSoil) {
  const Rig rig(Tractor());
  const int plane = rig.Id(mjOBJ_GEOM, "soil");
  for (int geom = 0; geom < rig.m().ngeom; ++geom) {
    if (geom == plane) continue;
    EXPECT_EQ(rig.m().geom_contype[geom] & rig.m().geom_conaffinity[plane], 0) << geom;
    EXPECT_EQ(rig.m().geom_contype[plane] & rig.m().geom_conaffinity[geom], 0) << geom;
  }
}

TEST(SoilBin, IsFreeToMoveAheadWhereSpinOrTorqueIsPrescribed) {
  SoilBin bin = Tractor();
  bin.mode = BinMode::kSpin;
  const Rig spun(bin);
  EXPECT_EQ(spun.Damping("forward"), 0);
  EXPECT_GT(spun.Damping("spin"), 0);
  EXPECT_EQ(spun.m().nu, 1);

  bin.mode = BinMode::kTorque;
  const Rig driven(bin);
  EXPECT_EQ(driven.Damping("forward"), 0);
  EXPECT_EQ(driven.Damping("spin"), 0);
  EXPECT_EQ(driven.m().nu, 1);
  const int motor = driven.Id(mjOBJ_ACTUATOR, kTorque);
  ASSERT_GE(motor, 0);
  EXPECT_EQ(driven.m().actuator_gear[6 * motor], 1);
}

}  // namespace
}  // namespace softsoil
