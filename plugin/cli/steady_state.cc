#include "plugin/cli/steady_state.h"

#include <algorithm>
#include <cmath>

#include "contact/tire_nodes.h"
#include "plugin/cli/bin_rig.h"
#include "plugin/cli/contact_ground.h"

namespace softsoil {
namespace {

constexpr double kRamp = 0.5;                                 // [s]
constexpr double kShortestWindow = 0.5;                       // [s]
constexpr double kWindowPerRadius = 0.5;                      // [-]
constexpr int kMostWindows = 12;                              //
constexpr int kSamples = 50;                                  // of the contact in a window
constexpr double kSteadyChange = 0.01, kPullPerLoad = 0.001;  // [-]

constexpr double kRounding = 1e-9;  // [-]  of volumes

long Steps(double time, const Simulation& simulation) {
  return std::max(1L, std::lround(time / simulation.model().opt.timestep));
}

// Sums of what a window reports.
class Window {
 public:
  explicit Window(const TireNodes& nodes) : centre_line_(nodes) {}

  void Add(const softsoilWheel& w) {
    ++steps_;
    for (double softsoilWheel::*part : kMeans) sum_.*part += w.*part;
  }
  void AddContact(const std::vector<softsoilContact>& contacts, double compaction_volume) {
    centre_line_.Add(contacts);
    compaction_volume_ += compaction_volume / kSamples;
  }

  SteadyState State(const Simulation& simulation) const {
    SteadyState state;
    state.wheel = simulation.Wheel(0);
    for (double softsoilWheel::*part : kMeans) state.wheel.*part = sum_.*part / steps_;
    state.compaction_volume = compaction_volume_;
    state.centre_line = centre_line_.Points();
    return state;
  }

 private:
  static constexpr double softsoilWheel::*kMeans[] = {
      &softsoilWheel::load,          &softsoilWheel::sinkage,
      &softsoilWheel::rut_depth,     &softsoilWheel::slip_ratio,
      &softsoilWheel::spin,          &softsoilWheel::forward_speed,
      &softsoilWheel::thrust,        &softsoilWheel::motion_resistance,
      &softsoilWheel::drawbar_pull,  &softsoilWheel::torque,
      &softsoilWheel::contact_area,  &softsoilWheel::mean_pressure,
      &softsoilWheel::peak_pressure, &softsoilWheel::compaction_power};

  softsoilWheel sum_ = {};
  int steps_ = 0;
  double compaction_volume_ = 0;  // [m^3]
  CentreLine centre_line_;
};

bool AreClose(double a, double b, double least) {
  return std::abs(a - b) <= std::max(kSteadyChange * std::abs(b), least);
}

bool IsSteady(const softsoilWheel& before, const softsoilWheel& now, double load) {
  return AreClose(before.drawbar_pull, now.drawbar_pull, kPullPerLoad * load) &&
         AreClose(before.sinkage, now.sinkage, 0) &&
         AreClose(before.forward_speed, now.forward_speed, 0);
}

// One case of the bin.
class Driven {
 public:
  Driven(const BinDrive& drive, const Tire& tire, double load, Simulation* simulation)
      : drive_(drive),
        nodes_(RingsOf(tire, simulation->Ground().grid_spacing)),
        load_(load),
        simulation_(simulation) {}

  // Speeds rise in proportion: the slip is right all the time.
  void Ramp() {
    const long steps = Steps(kRamp, *simulation_);
    for (long step = 1; step <= steps; ++step) {
      const double share = static_cast<double>(step) / steps;
      if (drive_.speed) simulation_->SetControl(kForward, share * *drive_.speed);
      if (drive_.spin) simulation_->SetControl(kSpin, share * *drive_.spin);
      StepUnlessSunk(load_, simulation_);
    }
  }

  SteadyState Through(double duration) {
    const long steps = Steps(duration, *simulation_);
    const softsoilGround before = simulation_->Ground();
    Window window(nodes_);
    long samples = 0;
    for (long step = 1; step <= steps; ++step) {
      StepUnlessSunk(load_, simulation_);
      window.Add(simulation_->Wheel(0));
      for (; samples < kSamples * step / steps; ++samples) {
        const std::vector<softsoilContact> contacts = simulation_->Contacts(0);
        window.AddContact(contacts, CompactionVolume(*simulation_, contacts, before.grid_spacing));
      }
    }
    SteadyState state = window.State(*simulation_);
    const softsoilGround after = simulation_->Ground();
    const double displaced = after.displaced_volume - before.displaced_volume;
    const double denser = after.densified_volume - before.densified_volume;
    const double rut = displaced + denser;
    state.densified_share = denser > kRounding * rut ? denser / rut : 0;
    return state;
  }

 private:
  const BinDrive& drive_;
  TireNodes nodes_;
  double load_;  // [N]
  Simulation* simulation_;
};

}  // namespace

SteadyState DriveToSteadyState(const BinDrive& drive, const Tire& tire, double load,
                               Simulation* rig) {
  if (!drive.spin) rig->SetDamper(kSpin, 0);
  const bool settled = Settle(load, rig);
  const double start = rig->Wheel(0).centre[0];
  Driven driven(drive, tire, load, rig);
  driven.Ramp();
  const double radius = tire.shape.radius;
  const double speed = drive.speed ? *drive.speed : *drive.spin * radius;
  const double window = std::max(kShortestWindow, kWindowPerRadius * radius / speed);
  SteadyState before = driven.Through(window), now;
  for (int k = 1; k < kMostWindows && !now.steady; ++k) {
    now = driven.Through(window);
    now.steady = IsSteady(before.wheel, now.wheel, load);
    before = now;
  }
  now.steady = now.steady && settled;
  now.distance = now.wheel.centre[0] - start;
  return now;
}

}  // namespace softsoil
