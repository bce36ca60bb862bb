#include "contact/wheel_contact.h"

#include <gtest/gtest.h>

#include <limits>

#include "contact/flat_plate.h"
#include "tests/contact/ground_samples.h"
#include "tests/contact/samples.h"

namespace softsoil {
namespace {

using Eigen::Vector3d;

constexpr double kStep = 0.001;  // [s]

// A wheel on the tilled loam, on the move in a rutted field.
struct RuttedField {
  Tire tire = AgriculturalTire();
  Soil soil = TilledLoam();
  WheelContact wheel{tire, 0.05};
  Surface surface{0.05, SurfaceMode::kFlow, Rising(0.1)};
  TirePose pose = PressedIn(tire, 0.1);

  RuttedField() {
    Press(&surface, 1, Waves);
    pose.frame_w = RotationAbout(Vector3d(0.2, 1, -0.4), 0.3);
    pose.velocity_w = Vector3d(1, 0.3, -0.2);
    pose.angular_velocity_w = Vector3d(0.1, 1.5, 0.2);
  }
  PatchForces Forces() const {
    PatchForces forces;
    wheel.Evaluate(pose, surface, soil, kStep, &forces);
    return forces;
  }
};

void ExpectSameBits(const PatchForces& a, const PatchForces& b) {
  EXPECT_EQ(a.wrench.force_w, b.wrench.force_w);
  EXPECT_EQ(a.wrench.torque_w, b.wrench.torque_w);
  ASSERT_EQ(a.contacts.size(), b.contacts.size());
  for (std::size_t i = 0; i < a.contacts.size(); ++i) {
    EXPECT_EQ(a.contacts[i].normal_force_w, b.contacts[i].normal_force_w);
    EXPECT_EQ(a.contacts[i].shear_force_w, b.contacts[i].shear_force_w);
  }
}

TEST(WheelContact, GivesTheGroundWhatItTakesFromIt) {
  const PatchForces forces = RuttedField().Forces();
  ASSERT_GT(forces.surface.size(), 50u);
  for (const Vector3d& at_w : {Vector3d(0, 0, 0), Vector3d(3, -2, 1), forces.wrench.at_w}) {
    Vector3d force_w = Vector3d::Zero(), torque_w = Vector3d::Zero();
    for (const SurfaceForce& s : forces.surface) {
      force_w += s.force_w;
      torque_w += (s.point_w - at_w).cross(s.force_w);
    }
    const Wrench wrench = About(forces.wrench, at_w);
    EXPECT_LT(RelativeError(force_w, -wrench.force_w), 1e-9);
    EXPECT_LT(RelativeError(torque_w, -wrench.torque_w), 1e-9);
  }
}

TEST(WheelContact, PressesOnTheGroundWhereTheGroundIs) {
  const RuttedField field;
  for (const SurfaceForce& s : field.Forces().surface) {
    // Nodes slide along their radius, over a surface that bends below them.
    EXPECT_LT(s.point_w.z(), field.surface.Height(s.point_w.x(), s.point_w.y()) + 0.03);
    EXPECT_GT(s.point_w.z(), field.surface.Height(s.point_w.x(), s.point_w.y()) - 0.15);
  }
}

TEST(WheelContact, NeverPullsAndNeverRubsBeyondItsFriction) {
  const RuttedField field;
  for (const NodeContact& c : field.Forces().contacts) {
    EXPECT_GE(c.pressure, 0);
    EXPECT_NEAR(c.normal_force_w.norm(), c.pressure * c.area, 1e-9);
    EXPECT_LE(c.shear_force_w.norm(),
              field.tire.soil_friction * c.normal_force_w.norm() * (1 + 1e-12));
    EXPECT_NEAR(c.shear_force_w.dot(c.normal_force_w), 0,
                1e-9 * (1 + c.normal_force_w.squaredNorm()));
  }
}

TEST(WheelContact, NeverPressesHarderThanTheSoilBears) {
  RuttedField field;
  field.pose.velocity_w.z() = -5;  // the damper must not exceed the capacity either
  const double k_e = BearingModulus(field.soil.bearing, field.tire.shape.width);
  for (const NodeContact& c : field.Forces().contacts) {
    EXPECT_LE(c.pressure, BearingPressure(k_e, field.soil.bearing.n, c.depth) * (1 + 1e-8));
  }
}

TEST(WheelContact, IsAQuestionThatChangesNothing) {
  const RuttedField field;
  PatchForces forces;
  const PatchForces first = field.Forces();
  for (int k = 0; k < 100; ++k) {
    field.wheel.Evaluate(field.pose, field.surface, field.soil, kStep, &forces);
    ExpectSameBits(forces, first);
  }
}

TEST(WheelContact, RemembersSlipOnlyOnceItIsCommitted) {
  RuttedField field;
  const PatchForces first = field.Forces();
  field.wheel.Commit(first);
  EXPECT_GT((field.Forces().wrench.force_w - first.wrench.force_w).norm(), 10);
  field.wheel.Reset();
  ExpectSameBits(field.Forces(), first);
}

TEST(WheelContact, ForgetsSlipInTheAir) {
  RuttedField field;
  const PatchForces first = field.Forces();
  field.wheel.Commit(first);
  const TirePose low = field.pose;
  field.pose.centre_w.z() += 1;
  field.wheel.Commit(field.Forces());
  field.pose = low;
  ExpectSameBits(field.Forces(), first);
}

TEST(WheelContact, FeelsNothingAboveTheGround) {
  RuttedField field;
  field.pose = PressedIn(field.tire, -0.2);
  EXPECT_EQ(field.Forces().wrench.force_w, Vector3d(0, 0, 0));
  EXPECT_TRUE(field.Forces().contacts.empty());
}

TEST(WheelContact, FeelsNothingAHairAboveTheGround) {
  const Tire tire = AgriculturalTire();
  const Surface level(0.05, SurfaceMode::kFlow, Level);
  PatchForces forces;
  WheelContact(tire, 0.01).Evaluate(PressedIn(tire, -1e-6), level, TilledLoam(), kStep, &forces);
  EXPECT_TRUE(forces.contacts.empty());
  WheelContact(tire, 0.01).Evaluate(PressedIn(tire, 1e-3), level, TilledLoam(), kStep, &forces);
  EXPECT_GT(forces.wrench.force_w.z(), 0);
}

TEST(WheelContact, MeetsRockAsItMeetsAPlate) {
  const Surface rock(0.05, SurfaceMode::kCompaction, Level);
  for (const Tire& tire : {AgriculturalTire(), TruckTire()}) {
    for (double depth : {0.02, 0.1}) {
      PatchForces forces;
      WheelContact(tire, 0.02).Evaluate(PressedIn(tire, depth), rock, Rock(), kStep, &forces);
      EXPECT_NEAR(forces.wrench.force_w.z() / FlatPlateLoad(tire, depth, 0.02), 1, 1e-6);
    }
  }
}

TEST(WheelContact, RefusesAPoseThatIsNotFinite) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (int quantity = 0; quantity < 4; ++quantity) {
    for (double bad : {nan, std::numeric_limits<double>::infinity()}) {
      RuttedField field;
      if (quantity == 0) field.pose.centre_w.y() = bad;
      if (quantity == 1) field.pose.frame_w(1, 2) = bad;
      if (quantity == 2) field.pose.velocity_w.x() = bad;
      if (quantity == 3) field.pose.angular_velocity_w.z() = bad;
      EXPECT_THROW(field.Forces(), std::runtime_error);
    }
  }
}

TEST(WheelContact, RefusesAWheelBeyondAllGrids) {
  RuttedField field;
  field.pose.centre_w.x() = -1.1e6;
  EXPECT_THROW(field.Forces(), std::runtime_error);
}

TEST(Wrench, KeepsItsMomentWhenItsPointMoves) {
  const Wrench w{Vector3d(1, 2, 3), Vector3d(-4, 5, 6), Vector3d(0.5, 0, -1)};
  const Wrench back = About(About(w, Vector3d(7, 8, 9)), w.at_w);
  EXPECT_LT(RelativeError(back.torque_w, w.torque_w), 1e-12);
  // A force at (1, 0, 0) along z turns about -y.
  const Wrench lever =
      About({Vector3d(0, 0, 2), Vector3d::Zero(), Vector3d(1, 0, 0)}, Vector3d::Zero());
  EXPECT_EQ(lever.torque_w, Vector3d(0, -2, 0));
}

}  // namespace
}  // namespace softsoil
