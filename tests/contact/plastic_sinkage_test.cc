#include "contact/plastic_sinkage.h"

#include <gtest/gtest.h>

#include <utility>

#include "contact/equilibrium.h"
#include "tests/contact/samples.h"

namespace softsoil {
namespace {

constexpr double kGrid = 0.025;  // [m]

struct Print {
  Surface surface{kGrid, SurfaceMode::kFlow, Level};
  std::vector<NodeSinkage> sinkage;

  // Presses the tire in once.
  void Press(const Tire& tire, const TirePose& pose, const Soil& soil) {
    SurfacePatch patch;
    const double reach = tire.shape.radius + tire.shape.width;
    surface.CopyPatch(pose.centre_w.x() - reach, pose.centre_w.x() + reach,
                      pose.centre_w.y() - reach, pose.centre_w.y() + reach, &patch);
    PlasticSinkage(tire, pose, patch, soil, &sinkage);
    for (const NodeSinkage& s : sinkage) surface.DeepenPlastic(s);
  }
};

TEST(PlasticSinkage, IsDeepestUnderTheMiddleOfTheTire) {
  Print print;
  print.Press(AgriculturalTire(), PressedIn(AgriculturalTire(), 0.1), TilledLoam());
  ASSERT_GT(print.sinkage.size(), 100u);
  const double middle = -print.surface.NodeHeight({0, 0});
  for (const NodeSinkage& s : print.sinkage) {
    EXPECT_LE(s.sinkage, middle);
    EXPECT_GT(s.sinkage, 0);
  }
}

TEST(PlasticSinkage, IsWhereTireAndSoilBalance) {
  const Tire tire = AgriculturalTire();
  const Soil soil = TilledLoam();
  Print print;
  print.Press(tire, PressedIn(tire, 0.1), soil);
  const double sinkage = -print.surface.NodeHeight({0, 0});
  EXPECT_NEAR(
      SpringPressure(tire.spring, 0.1 - sinkage) /
          BearingPressure(BearingModulus(soil.bearing, tire.shape.width), soil.bearing.n, sinkage),
      1, 1e-6);
}

// Also of a wheel that is in mud to its axle.
TEST(PlasticSinkage, StaysInsideTheTire) {
  const Tire tire = AgriculturalTire();
  Soil mud = TilledLoam();
  mud.bearing.k_phi /= 1e3;
  mud.bearing.k_c = 0;
  for (const auto& [soil, depth] : {std::pair(TilledLoam(), 0.1), std::pair(mud, 0.85)}) {
    const TirePose pose = PressedIn(tire, depth);
    Print print;
    print.Press(tire, pose, soil);
    ASSERT_GT(print.sinkage.size(), 100u);
    for (const NodeSinkage& s : print.sinkage) {
      const double x = s.node.i * kGrid, y = s.node.j * kGrid;
      EXPECT_LE(std::hypot(x, pose.centre_w.z()), RadiusAt(tire.shape, y));
      const double tire_bottom =
          pose.centre_w.z() - std::sqrt(std::pow(RadiusAt(tire.shape, y), 2) - x * x);
      EXPECT_LE(s.sinkage, -tire_bottom + 1e-12) << x << " " << y;
    }
  }
}

TEST(PlasticSinkage, HasEndedOnceTheWheelHasSunk) {
  Print print;
  const Tire tire = AgriculturalTire();
  for (int k = 0; k < 5; ++k) print.Press(tire, PressedIn(tire, 0.1), TilledLoam());
  const double settled = print.surface.RutVolume();
  for (int k = 0; k < 50; ++k) print.Press(tire, PressedIn(tire, 0.1), TilledLoam());
  EXPECT_NEAR(print.surface.RutVolume() / settled, 1, 0.01);
}

TEST(PlasticSinkage, IsNothingOnRockAndInTheAir) {
  Print print;
  print.Press(AgriculturalTire(), PressedIn(AgriculturalTire(), 0.1), Rock());
  EXPECT_LT(print.surface.RutVolume(), 1e-9);
  print.Press(AgriculturalTire(), PressedIn(AgriculturalTire(), -0.01), TilledLoam());
  EXPECT_TRUE(print.sinkage.empty());
}

TEST(PlasticSinkage, FollowsTheCamberOfTheWheel) {
  Print print;
  TirePose pose = PressedIn(TruckTire(), 0.08);
  pose.frame_w =
      RotationAbout(Eigen::Vector3d::UnitX(), 0.2);  // top to the right, foot to the left
  print.Press(TruckTire(), pose, TilledLoam());
  // The right edge of the tread goes down when the top leans to the right.
  EXPECT_LT(print.surface.NodeHeight({0, -3}), print.surface.NodeHeight({0, 3}));
}

}  // namespace
}  // namespace softsoil
