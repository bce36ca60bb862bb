#include "contact/mesh_contact.h"

#include <gtest/gtest.h>

#include "contact/soft_wheels.h"
#include "terrain/earth_pressure.h"
#include "tests/contact/mesh_samples.h"
#include "tests/contact/samples.h"

namespace softsoil {
namespace {

using Eigen::Vector3d;

constexpr double kGrid = 0.025, kStep = 0.001;  // [m], [s]

// Rigid: 1 MPa press it in by a tenth of a millimetre.
Tire Rigid(const TriangleMesh& mesh, double radius, double width) {
  Tire tire;
  tire.name = "rigid";
  tire.shape = {radius, std::numeric_limits<double>::infinity(), width};
  tire.spring.linear = 1e10;
  tire.damping = 0;
  tire.soil_friction = 0.5;
  tire.mesh = std::make_shared<TriangleMesh>(mesh);
  return tire;
}

double K_e(const Soil& soil, double width) { return BearingModulus(soil.bearing, width); }

struct Bench {
  explicit Bench(const Tire& tire, Soil s = TilledLoam())
      : soil(std::move(s)), contact(tire, kGrid), surface(kGrid, SurfaceMode::kFlow, Level) {}

  Wrench Ask(const TirePose& pose) {
    contact.Evaluate(pose, surface, soil, kStep, &forces);
    return forces.wrench;
  }
  // Moves on at the pose's velocity in ground that stays as it is.
  void Slide(TirePose* pose, double distance) {
    const int steps = static_cast<int>(distance / pose->velocity_w.norm() / kStep);
    for (int k = 0; k < steps; ++k) {
      Ask(*pose);
      contact.Commit(forces);
      pose->centre_w += kStep * pose->velocity_w;
    }
  }

  Soil soil;
  MeshContact contact;
  Surface surface;
  PatchForces forces;
};

TEST(MeshContact, BearsAPlateAsTheBearingLawSays) {
  const Soil soil = TilledLoam();
  Bench bench(Rigid(BoxMesh(0.4, 0.3, 0.1), 0.2, 0.3));
  for (double depth : {0.005, 0.02, 0.08}) {
    const Wrench wrench = bench.Ask(PoseAt(0, 0, 0.05 - depth));
    const double expected = 0.12 * BearingPressure(K_e(soil, 0.3), soil.bearing.n, depth);
    EXPECT_NEAR(wrench.force_w.z() / expected, 1, 0.01) << depth;
    EXPECT_NEAR(wrench.force_w.head<2>().norm() / expected, 0, 1e-9);
    EXPECT_NEAR(wrench.torque_w.norm() / expected, 0, 1e-9);
  }
  EXPECT_EQ(bench.Ask(PoseAt(0, 0, 0.051)).force_w.norm(), 0);
}

TEST(MeshContact, PushesBackWithThePassivePressureOnABlade) {
  const Soil soil = TilledLoam();
  const double depth = 0.1, width = 0.4;
  Bench bench(Rigid(BoxMesh(0.01, width, 0.3), 0.15, 0.01));
  TirePose pose = PoseAt(0, 0, 0.15 - depth);
  EXPECT_NEAR(bench.Ask(pose).force_w.x(), 0, 1e-9);  // at rest
  pose.velocity_w = {0.05, 0, 0};
  bench.Slide(&pose, 12 * soil.shear.modulus);
  bench.Ask(pose);
  double front = 0, back = 0;
  for (const NodeContact& c : bench.forces.contacts) {
    (c.point_w.x() > pose.centre_w.x() ? front : back) += c.normal_force_w.x();
  }
  const double gamma = 9.81 * InitialDensity(soil, 0);
  EXPECT_NEAR(front / (-width * PassiveForce(soil.shear, gamma, depth)), 1, 0.04);
  EXPECT_NEAR(back / front, 0, 1e-6);
}

TEST(MeshContact, LetsTheSoilGoWhenABladeDrawsBack) {
  Bench bench(Rigid(BoxMesh(0.01, 0.4, 0.3), 0.15, 0.01));
  TirePose pose = PoseAt(0, 0, 0.05);
  pose.velocity_w = {0.05, 0, 0};
  bench.Slide(&pose, 0.1);
  const double pushing = bench.Ask(pose).force_w.x();
  pose.velocity_w.setZero();
  EXPECT_NEAR(bench.Ask(pose).force_w.x() / pushing, 1, 1e-5);
  pose.velocity_w = {-0.05, 0, 0};
  bench.Slide(&pose, 0.2);
  EXPECT_NEAR(bench.Ask(pose).force_w.x() / -pushing, 1, 1e-3);  // now with its back
}

TEST(MeshContact, IsAQuestionThatChangesNothing) {
  Bench bench(Rigid(GrouserWheel{0.15, 0.1, 0.015, 0.004, 12, 5}.Mesh(), 0.165, 0.1));
  TirePose pose = PoseAt(0.003, 0, 0.14);
  pose.velocity_w = {0.1, 0.02, -0.01};
  pose.angular_velocity_w = {0, 1, 0};
  const Wrench once = bench.Ask(pose);
  EXPECT_GT(once.force_w.z(), 0);
  EXPECT_EQ(bench.Ask(pose).force_w, once.force_w);
  bench.contact.Commit(bench.forces);
  EXPECT_NE(bench.Ask(pose).force_w, once.force_w);
  const SlipMemory slip = bench.contact.Slip();
  const Wrench twice = bench.Ask(pose);
  bench.contact.Reset();
  EXPECT_EQ(bench.Ask(pose).force_w, once.force_w);
  bench.contact.SetSlip(slip);
  EXPECT_EQ(bench.Ask(pose).force_w, twice.force_w);
}

TEST(MeshContact, LeavesOnTheGroundWhatItTakesFromIt) {
  Bench bench(Rigid(SphereMesh(0.2, 40, 80), 0.2, 0.2));
  TirePose pose = PoseAt(0, 0, 0.15);
  pose.velocity_w = {0.2, 0.1, 0};
  const Wrench wrench = bench.Ask(pose);
  Vector3d on_ground = Vector3d::Zero();
  for (const SurfaceForce& f : bench.forces.surface) on_ground += f.force_w;
  EXPECT_LT(RelativeError(-on_ground, wrench.force_w), 1e-12);
}

// A wheel of triangles and one of revolution. The tread of the latter bears everywhere as if it
// were level, so that their forces agree the better the less it sinks.
TEST(MeshContact, BearsAWheelAsItsTorusIsBorne) {
  GrouserWheel drum = {0.5, 0.3, 0, 0, 1, 200};
  TriangleMesh mesh;
  mesh.vertices = {{0, -0.15, 0}, {0, 0.15, 0}};
  const int n = 300;
  for (double y : {-0.15, 0.15}) {
    for (int k = 0; k < n; ++k) {
      const double theta = 2 * kPi * k / n;
      mesh.vertices.emplace_back(drum.radius * std::sin(theta), y, drum.radius * std::cos(theta));
    }
  }
  for (int k = 0; k < n; ++k) {
    const int next = (k + 1) % n;
    mesh.triangles.push_back({0, 2 + next, 2 + k});
    mesh.triangles.push_back({1, 2 + n + k, 2 + n + next});
    AddQuad({2 + k, 2 + next, 2 + n + next, 2 + n + k}, &mesh);
  }
  RequireClosed(mesh);
  Tire tire = Rigid(mesh, 0.5, 0.3);
  Bench bench(tire);
  WheelContact torus(tire, kGrid);
  PatchForces of_torus;
  const TirePose pose = PressedIn(tire, 0.02);
  torus.Evaluate(pose, bench.surface, bench.soil, kStep, &of_torus);
  EXPECT_NEAR(bench.Ask(pose).force_w.z() / of_torus.wrench.force_w.z(), 1, 0.05);
}

// A mass on a plate in the soil bin.
struct Loaded {
  explicit Loaded(const Tire& tire, double mass_of) : mass(mass_of) {
    GroundSettings ground;
    ground.grid_spacing = kGrid;
    ground.sync = true;
    ground.threads = 1;
    wheels = std::make_unique<SoftWheels>(TilledLoam(), ground, Level, std::vector<Tire>{tire});
  }
  void Step() {
    wheels->Evaluate(0, pose, kStep, &forces[0]);
    wheels->Commit({pose}, forces, kStep);
    pose.velocity_w.z() += kStep * (forces[0].wrench.force_w.z() / mass - 9.81);
    pose.centre_w += kStep * pose.velocity_w;
  }
  std::unique_ptr<SoftWheels> wheels;
  double mass;
  TirePose pose = PoseAt(0, 0, 0.05);
  std::vector<PatchForces> forces{PatchForces{}};
};

TEST(RigidPlate, SinksUntilTheSoilBearsItAndComesToRest) {
  const double mass = 200;
  // As stiff as the step allows: a quarter of m / h^2.
  Tire plate = Rigid(BoxMesh(0.4, 0.3, 0.1), 0.2, 0.3);
  plate.spring.linear = mass / kStep / kStep / 4 / 0.12;
  plate.damping = 0.2 * plate.spring.linear * kStep;
  Loaded loaded(plate, mass);
  for (int k = 0; k < 1000; ++k) loaded.Step();
  const double settled = loaded.pose.centre_w.z();
  double most = 0;
  for (int k = 0; k < 1000; ++k) {
    loaded.Step();
    most = std::max(most, std::abs(loaded.forces[0].wrench.force_w.z() / mass / 9.81 - 1));
  }
  const Soil soil = TilledLoam();
  const double static_depth = std::pow(mass * 9.81 / 0.12 / K_e(soil, 0.3), 1 / soil.bearing.n);
  EXPECT_GT(0.05 - settled, static_depth);
  EXPECT_LT(0.05 - settled, 4 * static_depth);  // it dropped in
  EXPECT_NEAR(loaded.pose.centre_w.z(), settled, 1e-4);
  EXPECT_LT(most, 0.02);
}

TEST(RigidPlate, LeavesItsPrintInTheGround) {
  Loaded loaded(Rigid(BoxMesh(0.4, 0.3, 0.1), 0.2, 0.3), 200);
  loaded.pose = PoseAt(0.01, 0.01, 0.02);
  loaded.Step();
  const Surface& surface = loaded.wheels->ground().surface();
  EXPECT_NEAR(surface.Height(0, 0), -0.03, 1e-4);
  EXPECT_NEAR(surface.Height(0.2, 0.15), -0.03, 1e-4);
  EXPECT_EQ(surface.Height(0.25, 0), 0);
  EXPECT_NEAR(surface.RutVolume(), 0.03 * 0.4 * 0.3, 0.1 * 0.03 * 0.4 * 0.3);
}

}  // namespace
}  // namespace softsoil
