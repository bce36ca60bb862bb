// Nothing depends on threads or on the time of day.
#include <gtest/gtest.h>

#include "contact/soft_wheels.h"
#include "tests/contact/samples.h"

namespace softsoil {
namespace {

using Eigen::Vector3d;

// Yields to the load of a truck, so that the columns below have work to do.
Soil LooseLoam() {
  Soil soil = TilledLoam();
  soil.compaction.initial_density = 900;
  return soil;
}

struct Drive {
  int threads = 1;
  bool sync = true;

  GroundSettings Settings() const {
    GroundSettings settings;
    settings.grid_spacing = 0.05;
    settings.threads = threads;
    settings.sync = sync;
    return settings;
  }

  // Two wheels side by side, driven and steered; everything they felt and left.
  std::vector<double> Run() const {
    const Tire tire = TruckTire();
    SoftWheels wheels(LooseLoam(), Settings(), Level, {tire, tire});
    std::vector<double> history;
    std::vector<PatchForces> forces(2);
    std::vector<TirePose> poses = {PressedIn(tire, 0.05), PressedIn(tire, 0.07)};
    poses[1].centre_w.y() = 0.6;
    for (int k = 0; k < 200; ++k) {
      for (int wheel = 0; wheel < 2; ++wheel) {
        TirePose& pose = poses[wheel];
        pose.velocity_w = Vector3d(2, 0.3, 0);
        pose.centre_w += 0.002 * pose.velocity_w;
        pose.angular_velocity_w = Vector3d(0, 5, 0);
        pose.frame_w = RotationAbout(Vector3d::UnitY(), 0.01 * k);
        wheels.Evaluate(wheel, pose, 0.002, &forces[wheel]);
        for (int i = 0; i < 3; ++i) history.push_back(forces[wheel].wrench.force_w[i]);
        for (int i = 0; i < 3; ++i) history.push_back(forces[wheel].wrench.torque_w[i]);
      }
      wheels.Commit(poses, forces, 0.002);
    }
    wheels.ground().surface().ForEachNode(
        [&](GridNode, double height, double) { history.push_back(height); });
    for (int wheel = 0; wheel < 2; ++wheel) history.push_back(wheels.ground().Work(wheel).energy);
    return history;
  }
};

TEST(SameBits, ComeFromAnyNumberOfThreads) {
  const std::vector<double> one = Drive{1, true}.Run();
  EXPECT_GT(one.back(), 1);  // [J]  there was compaction to compare
  EXPECT_EQ(one, (Drive{2, true}.Run()));
  EXPECT_EQ(one, (Drive{5, true}.Run()));
}

TEST(SameBits, ComeFromTheBackground) {
  const std::vector<double> one = Drive{1, false}.Run();
  EXPECT_EQ(one, (Drive{1, false}.Run()));
  EXPECT_EQ(one, (Drive{2, false}.Run()));
}

// The surface after each tick under a load that stays the same.
std::vector<double> VolumesByTick(bool sync, int ticks) {
  Drive drive{1, sync};
  const Soil soil = LooseLoam();
  const WheelContact wheel(TruckTire(), 0.05);
  PatchForces forces;
  wheel.Evaluate(PressedIn(TruckTire(), 0.08), Surface(0.05, SurfaceMode::kFlow, Level), soil, 0.01,
                 &forces);
  Ground ground(soil, drive.Settings(), Level, 1);
  std::vector<double> volumes;
  for (int tick = 0; tick < ticks; ++tick) {
    ground.AddLoad(0, forces.surface, 0.01);
    ground.Pass(0.01);
    volumes.push_back(ground.surface().RutVolume());
  }
  return volumes;
}

TEST(SameBits, ComeOnePeriodLaterInTheBackground) {
  std::vector<double> sync = VolumesByTick(true, 20), background = VolumesByTick(false, 21);
  EXPECT_GT(sync.back(), sync.front());
  EXPECT_EQ(background.front(), 0);
  background.erase(background.begin());
  EXPECT_EQ(sync, background);
}

}  // namespace
}  // namespace softsoil
