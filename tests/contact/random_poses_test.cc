// Whatever a wheel does, every quantity stays a number.
#include <gtest/gtest.h>

#include <random>

#include "contact/plastic_sinkage.h"
#include "contact/wheel_report.h"
#include "terrain/point_load.h"
#include "tests/contact/ground_samples.h"
#include "tests/contact/samples.h"

namespace softsoil {
namespace {

using Eigen::Vector3d;

class Poses {
 public:
  TirePose Next() {
    const double reach = Pick() < 0.05 ? 1e5 : 1.5, speed = std::pow(10, 6 * Pick() - 4);
    TirePose pose;
    pose.centre_w = {reach * Signed(), reach * Signed(), 2 * Signed()};
    pose.frame_w =
        Eigen::Quaterniond(Signed(), Signed(), Signed(), Signed()).normalized().toRotationMatrix();
    if (Pick() < 0.1) pose.frame_w = RotationAbout(Vector3d::UnitX(), kPi / 2);  // on its side
    if (Pick() < 0.1) pose.frame_w = RotationAbout(Vector3d::UnitX(), kPi);      // upside down
    pose.velocity_w = speed * Vector3d(Signed(), Signed(), Signed());
    pose.angular_velocity_w = speed * Vector3d(Signed(), Signed(), Signed());
    if (Pick() < 0.05) pose.velocity_w.setZero();
    return pose;
  }
  double Pick() { return std::uniform_real_distribution<double>(0, 1)(random_); }

 private:
  double Signed() { return 2 * Pick() - 1; }
  std::mt19937 random_{1};
};

bool Finite(const PatchForces& forces) {
  bool finite = forces.wrench.force_w.allFinite() && forces.wrench.torque_w.allFinite();
  for (const NodeContact& c : forces.contacts) {
    finite = finite && c.point_w.allFinite() && c.normal_force_w.allFinite() &&
             c.shear_force_w.allFinite() && std::isfinite(c.pressure) && std::isfinite(c.depth) &&
             c.pressure >= 0 && c.area >= 0 &&
             std::hypot(c.mobilisation.t, c.mobilisation.b) <= 1 + 1e-12;
  }
  return finite;
}

bool Finite(const WheelReport& r) {
  for (double value :
       {r.load, r.sinkage, r.rut_depth, r.slip_ratio, r.slip_angle, r.camber, r.spin,
        r.forward_speed, r.thrust, r.motion_resistance, r.drawbar_pull, r.lateral_force, r.torque,
        r.contact_area, r.mean_pressure, r.peak_pressure}) {
    if (!std::isfinite(value)) return false;
  }
  return true;
}

bool Finite(const std::vector<NodeSinkage>& sinkage) {
  for (const NodeSinkage& s : sinkage) {
    if (!std::isfinite(s.sinkage) || s.sinkage > 5) return false;
  }
  return true;
}

TEST(RandomPoses, GiveFiniteQuantities) {
  Surface field(0.05, SurfaceMode::kFlow, [](double x, double y) { return 0.3 * std::sin(x + y); });
  Press(&field, 2, Waves);
  const Tire tires[] = {AgriculturalTire(), TruckTire()};
  WheelContact wheels[] = {{tires[0], 0.1}, {tires[1], 0.1}};
  const Soil soils[] = {TilledLoam(), SoilNamed("heavy_clay_25"), Rock()};
  Poses poses;
  PatchForces forces;
  std::vector<NodeSinkage> plastic;
  int touching = 0;
  for (int k = 0; k < 20000; ++k) {
    const TirePose pose = poses.Next();
    const Soil& soil = soils[k % 3];
    WheelContact& wheel = wheels[k % 2];
    wheel.Evaluate(pose, field, soil, 0.002, &forces);
    PlasticSinkage(wheel.tire(), pose, forces.patch, soil, &plastic);
    ASSERT_TRUE(Finite(forces)) << k;
    ASSERT_TRUE(Finite(ReportOf(wheel.tire(), pose, forces))) << k;
    ASSERT_TRUE(Finite(plastic)) << k;
    if (poses.Pick() < 0.5) wheel.Commit(forces);
    touching += !forces.contacts.empty();
  }
  EXPECT_GT(touching, 10000);
}

}  // namespace
}  // namespace softsoil
