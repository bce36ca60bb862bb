// A tire with lugs on rigid, soft and firm ground.
#include <gtest/gtest.h>

#include <cmath>

#include "terrain/constants.h"
#include "tests/contact/soil_bin.h"

namespace softsoil {
namespace {

Tire Lugged() { return TireNamed("18.4R38_85kPa_lugged"); }

PatchForces PressedInto(const Soil& soil, const Tire& tire, double depth, double v_x = 0) {
  WheelContact wheel(Undamped(tire), 0.02);
  TirePose pose = PressedIn(tire, depth);
  pose.velocity_w.x() = v_x;
  PatchForces forces;
  wheel.Evaluate(pose, Surface(0.05, SurfaceMode::kFlow, Level), soil, 1, &forces);
  return forces;
}

// A test on a plate knows no lugs: it gives the spring of the tread as a whole.
TEST(LuggedTire, BearsOnRigidGroundWhatASmoothOneBearsButOnItsLugs) {
  const Tire tire = Lugged();
  const TireNodes nodes = MakeTireNodes(tire.shape, 0.02);
  const PatchForces forces = PressedInto(Rock(), tire, 0.06);
  const double smooth = PressedInto(Rock(), AgriculturalTire(), 0.06).wrench.force_w.z();
  EXPECT_NEAR(forces.wrench.force_w.z() / smooth, 1, 0.05);
  int on_lug = 0;
  for (const NodeContact& c : forces.contacts) {
    if (!nodes.on_lug[c.node]) {
      EXPECT_EQ(c.pressure, 0);
      continue;
    }
    const Eigen::Vector3d& node_t = nodes.position_t[c.node];
    const double below = 0.06 - tire.shape.radius - node_t.z();  // the plate is level
    const double d = below * nodes.radius[c.node] / -node_t.z();
    EXPECT_NEAR(c.pressure * 0.25 / (346900 * std::sqrt(d)), 1, 1e-3);
    ++on_lug;
  }
  EXPECT_GT(on_lug, 20);
}

// (1 - v) p_l(z) + v p_b(z - h) = f(d), by halving; d and z along the vertical.
TEST(LuggedTire, BalancesItsSpringWithTheSoilBelowTheLugsAndBetweenThem) {
  const Tire tire = Lugged();
  const double gap = 2 * kPi * 0.91 / 22 * 0.75, height = 0.038;
  const double below = 6800 / (gap / 3 * std::sqrt(0.5)) + 1134000;
  const double between = 6800 / (gap * std::sqrt(0.5)) + 1134000;
  const auto lug = [&](double z) { return below * std::pow(z, 0.85); };
  const auto carcass = [&](double z) {
    return z > height ? between * std::pow(z - height, 0.85) : 0;
  };
  for (const double penetration : {0.02, 0.06, 0.12}) {
    double low = 0, high = penetration;
    for (int i = 0; i < 60; ++i) {
      const double z = (low + high) / 2;
      const double soil = 0.25 * lug(z) + 0.75 * carcass(z);
      (soil < 346900 * std::sqrt(penetration - z) ? low : high) = z;
    }
    const TreadState state =
        Equilibrium(tire.spring, CurveUnder(TilledLoam(), tire.shape), {penetration, 0, 1, 1});
    EXPECT_NEAR(state.depth, low, 1e-8);
    EXPECT_NEAR(state.on_lugs / lug(low), 1, 1e-6);
    EXPECT_NEAR(state.between_lugs, carcass(low), 1e-3 * lug(low));
  }
}

// Rubber that can pass next to nothing to the soil.
TEST(LuggedTire, DoesNotSlipOnRubberBetweenItsLugs) {
  Tire lugged = Lugged(), smooth = AgriculturalTire();
  lugged.soil_friction = smooth.soil_friction = 0.05;
  const auto thrust = [](const Tire& tire) {
    const PatchForces forces = PressedInto(TilledLoam(), tire, 0.1, -1);  // slides back, locked
    double sum = 0;
    for (const NodeContact& c : forces.contacts) sum += c.shear_force_w.x();
    return sum / forces.wrench.force_w.z();
  };
  EXPECT_LT(thrust(smooth), 0.051);
  EXPECT_GT(thrust(lugged), 0.1);
}

// Coulomb's law for the whole contact and the sides of Bekker (1956), which nothing may exceed:
// c A (1 + 2 h / b) + W tan(phi) (1 + 0.64 (h / b) arccot(h / b)).
TEST(LuggedTire, PullsNoMoreThanTheSoilBears) {
  const Tire tire = Lugged();
  for (const Soil& soil : {TilledLoam(), SoilNamed("firm_yolo_loam")}) {
    const PatchForces forces = PressedInto(soil, tire, 0.12, -1);
    double shear = 0, area = 0, load = 0;
    for (const NodeContact& c : forces.contacts) {
      shear += c.shear_force_w.norm();
      area += c.area;
      load += c.pressure * c.area;
    }
    const double h_b = 0.038 / 0.467;
    const double most =
        soil.shear.cohesion * area * (1 + 2 * h_b) +
        load * std::tan(soil.shear.friction_angle) * (1 + 0.64 * h_b * std::atan(1 / h_b));
    EXPECT_LT(shear, 1.001 * most);
    EXPECT_GT(shear, 0.6 * most);
  }
}

// Lugs that stand in firm ground without filling the space between them: no more than 2.75.
TEST(LuggedTire, BreaksAWedgeOutOfFirmGround) {
  const Tire tire = Lugged();
  const TireNodes nodes = MakeTireNodes(tire.shape, 0.02);
  const PatchForces forces = PressedInto(SoilNamed("firm_yolo_loam"), tire, 0.03, -1);
  const double n_phi = std::pow(std::tan((45 + 23.13 / 2) * kPi / 180), 2);
  const double gap = 2 * kPi * 0.91 / 22 * 0.75;
  int open = 0;
  for (const NodeContact& c : forces.contacts) {
    if (nodes.on_lug[c.node] || c.pressure > 0) continue;
    const double z = -c.point_w.z();  // of the tips
    const double passive = 1504 * 9.81 * n_phi * z * z / 2 + 2 * 35720 * z * std::sqrt(n_phi);
    EXPECT_NEAR(c.strength / (passive / gap), 1, 1e-3);
    EXPECT_LT(c.strength, 35720);
    ++open;
  }
  EXPECT_GT(open, 20);
}

TEST(LuggedTire, LeavesTheirPatternInTheGround) {
  SoilBinSettings settings;
  settings.tire = Lugged();
  settings.grid_spacing = 0.025;
  SoilBin bin(settings);
  bin.Drive(0.3, 0, 0);
  bin.Drive(0.8, 1, 0.03);
  // The middle of the rut behind the wheel: places of lugs and places between them.
  int low = 0, high = 0, changes = 0;
  bool was_low = false;
  double deepest = 0;
  const auto sinkage = [&](double x) { return -bin.ground().surface().Height(x, 0.05); };
  for (double x = 0; x < 0.55; x += 0.025) deepest = std::max(deepest, sinkage(x));
  for (double x = 0; x < 0.55; x += 0.025) {
    const bool is_low = sinkage(x) > deepest - 0.012;
    const bool is_high = sinkage(x) < deepest - 0.026;
    low += is_low;
    high += is_high;
    if (is_low || is_high) {
      changes += is_low != was_low;
      was_low = is_low;
    }
  }
  EXPECT_GT(low, 3);
  EXPECT_GT(high, 6);
  EXPECT_GE(changes, 3);  // 0.55 m have two lugs
}

TEST(LuggedTire, GoesOnFromItsMemoryWithTheSameBits) {
  const Tire tire = Lugged();
  WheelContact first(tire, 0.05), second(tire, 0.05);
  const Surface surface(0.05, SurfaceMode::kFlow, Level);
  TirePose pose = PressedIn(tire, 0.1);
  pose.velocity_w = {0.8, 0.1, 0};
  PatchForces forces;
  first.Evaluate(pose, surface, TilledLoam(), 0.01, &forces);
  first.Commit(forces);
  std::vector<unsigned char> bytes;
  StateWriter writer([&](const void* more, std::size_t count) {
    const auto* begin = static_cast<const unsigned char*>(more);
    bytes.insert(bytes.end(), begin, begin + count);
  });
  Write(first.Slip(), writer);
  writer.Finish();
  StateReader reader(bytes.data(), bytes.size());
  second.SetSlip(ReadSlipMemory(reader, second.nodes().size()));
  // Lifted a little it remembers how deep its lugs were.
  pose.centre_w.z() += 0.01;
  PatchForces again, fresh;
  first.Evaluate(pose, surface, TilledLoam(), 0.01, &forces);
  second.Evaluate(pose, surface, TilledLoam(), 0.01, &again);
  EXPECT_EQ(forces.wrench.force_w, again.wrench.force_w);
  EXPECT_EQ(forces.wrench.torque_w, again.wrench.torque_w);
  second.Reset();
  second.Evaluate(pose, surface, TilledLoam(), 0.01, &fresh);
  EXPECT_GT(fresh.wrench.force_w.z(), 1.05 * forces.wrench.force_w.z());
}

}  // namespace
}  // namespace softsoil
