// Wheels that stand on the border of two soils.
#include <gtest/gtest.h>

#include <functional>

#include "contact/mesh_sinkage.h"
#include "contact/plastic_sinkage.h"
#include "contact/soft_wheels.h"
#include "terrain/state_stream.h"
#include "tests/contact/mesh_samples.h"
#include "tests/contact/samples.h"

namespace softsoil {
namespace {

using Eigen::Vector2d;

constexpr double kGrid = 0.025, kBorder = 0.013;  // [m]

Soil Slippery(const char* name, double slip_sinkage) {
  Soil soil = SoilNamed(name);
  soil.slip_sinkage = slip_sinkage;
  return soil;
}
Soil Right() { return Slippery("firm_yolo_loam", 0.1); }
Soil Left() { return Slippery("tilled_yolo_loam", 0.4); }

// Left() to the left of the border, Right() elsewhere.
SoilMap Both() {
  const Vector2d half(50, 50);
  return SoilMap(Right(), {{Left(), {0, kBorder + 50}, half.asDiagonal()}});
}

TirePose Slipping(const Tire& tire) {
  TirePose pose = PressedIn(tire, 0.06);
  pose.velocity_w = {1, 0.1, -0.1};
  pose.angular_velocity_w = {0, 4, 0};
  return pose;
}

Tire MeshTire() {
  Tire tire = TruckTire();
  const double r = tire.shape.radius, width = tire.shape.width;
  tire.mesh = std::make_shared<TriangleMesh>(GrouserWheel{r, width, 0.02, 0.02, 12, 4}.Mesh());
  return tire;
}

// Contacts of a wheel in three soils: both, the right one alone and the left one alone.
template <class Contact>
class ThreeSoils {
 public:
  explicit ThreeSoils(const Tire& tire) {
    const Contact contact(tire, kGrid);
    const Surface surface(kGrid, SurfaceMode::kFlow, Level);
    const SoilMap soils[] = {Both(), Right(), Left()};
    const auto sink = tire.mesh != nullptr ? PlasticSinkageOfMesh : PlasticSinkage;
    for (int k = 0; k < 3; ++k) {
      contact.Evaluate(Slipping(tire), surface, soils[k], 0.001, &forces[k]);
      sink(tire, Slipping(tire), forces[k].patch, soils[k], &sinkage[k]);
    }
  }

  // Every node and every rut is that of its soil alone, to the bit.
  void ExpectEachSoilWhereItLies() const {
    int nodes[2] = {0, 0};
    for (const NodeContact& c : forces[0].contacts) {
      const NodeContact& alone = *Of(c.node, forces[c.soil == 0 ? 1 : 2].contacts);
      EXPECT_EQ(c.pressure, alone.pressure);
      EXPECT_EQ(c.slip_sinkage, alone.slip_sinkage);
      EXPECT_EQ(c.shear_force_w, alone.shear_force_w);
      ++nodes[c.soil];
    }
    EXPECT_GT(nodes[0], 20);
    EXPECT_GT(nodes[1], 20);
    int ruts[2] = {0, 0};
    for (const NodeSinkage& s : sinkage[0]) {
      const int soil = s.node.j * kGrid > kBorder ? 1 : 0;
      EXPECT_EQ(s.sinkage, At(s.node, sinkage[soil == 0 ? 1 : 2]));
      ++ruts[soil];
    }
    EXPECT_GT(ruts[0], 20);
    EXPECT_GT(ruts[1], 20);
  }

  PatchForces forces[3];
  std::vector<NodeSinkage> sinkage[3];

 private:
  static const NodeContact* Of(int node, const std::vector<NodeContact>& contacts) {
    for (const NodeContact& c : contacts) {
      if (c.node == node) return &c;
    }
    ADD_FAILURE() << "node " << node << " has no contact";
    return &contacts.front();
  }
  static double At(GridNode node, const std::vector<NodeSinkage>& sinkage) {
    for (const NodeSinkage& s : sinkage) {
      if (s.node.i == node.i && s.node.j == node.j) return s.sinkage;
    }
    return 0;
  }
};

TEST(Border, LetsEachNodeOfATireStandInItsOwnSoil) {
  ThreeSoils<WheelContact>(TruckTire()).ExpectEachSoilWhereItLies();
}

TEST(Border, LetsEachNodeOfAMeshStandInItsOwnSoil) {
  ThreeSoils<MeshContact>(MeshTire()).ExpectEachSoilWhereItLies();
}

TEST(Border, LetsALuggedTirePullMoreThanInTheWeakerAndLessThanInTheStrongerSoil) {
  const ThreeSoils<WheelContact> wheel(TireNamed("18.4R38_85kPa_lugged"));
  const auto pull = [&](int k) { return wheel.forces[k].wrench.force_w.x(); };
  EXPECT_LT(pull(0), pull(1));
  EXPECT_GT(pull(0), pull(2));
}

TEST(Region, UnderAllOfALuggedTireIsAsItsSoilAlone) {
  const Tire tire = TireNamed("18.4R38_85kPa_lugged");
  const auto wrench = [&](const SoilMap& soils) {
    PatchForces forces;
    const Surface surface(kGrid, SurfaceMode::kFlow, Level);
    WheelContact(tire, kGrid).Evaluate(Slipping(tire), surface, soils, 0.001, &forces);
    return forces.wrench;
  };
  const Vector2d half(50, 50);
  for (const auto& [soil, around] : {std::pair(Left(), Right()), std::pair(Right(), Left())}) {
    const Wrench in_region = wrench(SoilMap(around, {{soil, {0, 0}, half.asDiagonal()}}));
    EXPECT_EQ(in_region.force_w, wrench(soil).force_w);
    EXPECT_EQ(in_region.torque_w, wrench(soil).torque_w);
    EXPECT_NE(in_region.force_w, wrench(around).force_w);
  }
}

TEST(Border, GivesTheFlankTheSoilThatItPushes) {
  const Tire tire = TruckTire();
  const auto flank = [&](const SoilMap& soils) {
    const WheelContact contact(tire, kGrid);
    TirePose pose = PressedIn(tire, 0.06);
    pose.velocity_w = {0, 5, 0};
    PatchForces forces;
    contact.Evaluate(pose, Surface(kGrid, SurfaceMode::kFlow, Level), soils, 0.001, &forces);
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const NodeContact& c : forces.contacts) sum += c.flank_force_w;
    return sum.y();
  };
  // The border lies between the edge of the tread and what stands one node beyond.
  const Vector2d half(50, 50);
  const double border = tire.shape.width / 2 + kGrid / 2;
  const SoilMap beside(Left(), {{Right(), {0, border + 50}, half.asDiagonal()}});
  ASSERT_LT(flank(Right()), 0);
  EXPECT_LT(flank(beside), 2 * flank(Left()));
}

// A wheel rolls along the border. Hash of the ground that it leaves.
std::uint64_t Rut(const SoilMap& soils, int threads, Ground* ground) {
  GroundSettings settings;
  settings.grid_spacing = settings.volume_height = 0.05;
  settings.volumes = 10;
  settings.threads = threads;
  const Tire tire = TruckTire();
  SoftWheels wheels(soils, settings, Level, {tire});
  std::vector<PatchForces> forces(1);
  TirePose pose = Slipping(tire);
  pose.velocity_w = {1, 0, 0};
  for (int k = 0; k < 60; ++k) {
    pose.centre_w += 0.002 * pose.velocity_w;
    wheels.Evaluate(0, pose, 0.002, &forces[0]);
    wheels.Commit({pose}, forces, 0.002);
  }
  StateWriter writer;
  Write(wheels.State(), writer);
  *ground = wheels.ground();
  return writer.Finish();
}

SoilMap Loosened() {
  Soil right = Right(), left = Left();
  right.compaction.initial_density = 1000;
  left.compaction.initial_density = 900;
  const Vector2d half(50, 50);
  return SoilMap(right, {{left, {0, kBorder + 50}, half.asDiagonal()}});
}

TEST(Border, HasTheSameBitsOnAnyNumberOfThreads) {
  Ground one(Left(), {}, Level, 1), four = one;
  EXPECT_EQ(Rut(Loosened(), 1, &one), Rut(Loosened(), 4, &four));
  EXPECT_GT(one.Work(0).energy, 1);  // [J]  there was compaction to compare
}

TEST(Border, KeepsTheVolumeOfTheSoilThatMovesAcross) {
  Ground ground(Left(), {}, Level, 1);
  Rut(Both(), 1, &ground);
  const double displaced = ground.surface().DisplacedVolume();
  EXPECT_GT(displaced, 1e-4);
  EXPECT_NEAR(ground.surface().MovedVolume() + ground.VolumeInHand(), displaced, 1e-12);
}

TEST(Border, HasADeeperRutOnItsSofterSide) {
  Ground ground(Left(), {}, Level, 1);
  Rut(Both(), 1, &ground);
  const Surface& surface = ground.surface();
  EXPECT_LT(surface.Height(0.05, 0.1), 1.5 * surface.Height(0.05, -0.1));
}

TEST(Border, OfARegionOfTheSameSoilIsNone) {
  Soil soil = Left();
  soil.compaction.initial_density = 900;
  const Vector2d half(50, 50);
  const SoilMap twice(soil, {{soil, {0, kBorder + 50}, half.asDiagonal()}});
  Ground one(soil, {}, Level, 1), two = one;
  EXPECT_EQ(Rut(soil, 1, &one), Rut(twice, 1, &two));
}

}  // namespace
}  // namespace softsoil
