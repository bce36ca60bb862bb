// The soil bin of Madsen (2014) 6.3.1 reduced to a wheel: travel and spin are prescribed, the load
// rests on it and may rise and fall.
#pragma once

#include <functional>
#include <vector>

#include "contact/soft_wheels.h"
#include "tests/contact/samples.h"

namespace softsoil {

struct SoilBinSettings {
  Soil soil = TilledLoam();
  Tire tire = AgriculturalTire();
  double load = 18000;  // [N]
  double grid_spacing = 0.05;
  SurfaceMode mode = SurfaceMode::kFlow;
  double step = 0.002;  // [s]
};

class SoilBin {
 public:
  explicit SoilBin(const SoilBinSettings& settings)
      : settings_(settings),
        wheels_(settings.soil, GroundOf(settings), Level, {settings.tire}),
        pose_(PressedIn(settings.tire, 0)) {}

  // Drives for `seconds` at a speed [m/s] and slip [-]; the mean report.
  WheelReport Drive(double seconds, double speed, double slip) {
    pose_.velocity_w.x() = speed;
    pose_.angular_velocity_w.y() = speed * (1 + slip) / settings_.tire.shape.radius;
    WheelReport mean{};
    const int steps = static_cast<int>(std::lround(seconds / settings_.step));
    for (int k = 0; k < steps; ++k) {
      const WheelReport report = Step();
      mean.load += report.load / steps;
      mean.thrust += report.thrust / steps;
      mean.motion_resistance += report.motion_resistance / steps;
      mean.drawbar_pull += report.drawbar_pull / steps;
      mean.torque += report.torque / steps;
      mean.sinkage += report.sinkage / steps;
      mean.rut_depth += report.rut_depth / steps;
    }
    return mean;
  }

  // Sinks in, gets going for a metre, then half a metre of measurement.
  WheelReport Measure(double slip) {
    Drive(0.6, 0, 0);
    Drive(1, 1, slip);
    return Drive(0.5, 1, slip);
  }

  void Lift() { pose_.centre_w.z() += 1; }
  void PutDownAt(double x) {
    pose_.centre_w = {x, 0, settings_.tire.shape.radius};
    pose_.velocity_w.setZero();
  }

  Ground& ground() { return wheels_.ground(); }
  TirePose& pose() { return pose_; }
  const PatchForces& forces() const { return forces_[0]; }

  WheelReport Step() {
    const double h = settings_.step, mass = settings_.load / 9.81;
    wheels_.Evaluate(0, pose_, h, &forces_[0]);
    const WheelReport report = ReportOf(settings_.tire, pose_, forces_[0]);
    wheels_.Commit({pose_}, forces_, h);
    // 5/s: the damper of the rig.
    pose_.velocity_w.z() += h * (report.load / mass - 9.81 - 5 * pose_.velocity_w.z());
    pose_.centre_w += h * pose_.velocity_w;
    pose_.frame_w =
        RotationAbout(Eigen::Vector3d::UnitY(), h * pose_.angular_velocity_w.y()) * pose_.frame_w;
    return report;
  }

 private:
  static GroundSettings GroundOf(const SoilBinSettings& settings) {
    GroundSettings ground;
    ground.grid_spacing = settings.grid_spacing;
    ground.volume_height = 0.05;
    ground.volumes = 15;
    ground.mode = settings.mode;
    ground.sync = true;
    return ground;
  }

  SoilBinSettings settings_;
  SoftWheels wheels_;
  TirePose pose_;
  std::vector<PatchForces> forces_ = std::vector<PatchForces>(1);
};

}  // namespace softsoil
