#include "plugin/cli/steady_state.h"

#include <algorithm>
#include <cmath>

#include "plugin/cli/contact_ground.h"
#include "plugin/cli/soil_bin.h"
#include "terrain/input_error.h"

namespace softsoil {
namespace {

constexpr double kRamp = 0.5;                                 // [s]
constexpr double kShortestWindow = 0.5;                       // [s]
constexpr double kWindowPerRadius = 0.5;                      // [-]
constexpr int kMostWindows = 12;                              //
constexpr int kSamples = 50;                                  // of the contact in a window
constexpr double kSteadyChange = 0.01, kPullPerLoad = 0.001;  // [-]

constexpr double kRounding = 1e-9;  // [-]  of volumes

constexpr double kShortestSettling = 0.3, kLongestSettling = 5, kAtRest = 0.1;  // [s]
constexpr double kLoadError = 0.01;                                             // [-]

long Steps(double time, const Simulation& simulation) {
  return std::max(1L, std::lround(time / simulation.model().opt.timestep));
}

// Sums of what a window reports.
class Window {
 public:
  void Add(const softsoilWheel& w) {
    ++steps_;
    for (double softsoilWheel::*part : kMeans) sum_.*part += w.*part;
  }
  void AddContact(const std::vector<softsoilContact>& contacts, double sunk_volume) {
    centre_line_.Add(contacts);
    sunk_volume_ += sunk_volume / kSamples;
  }

  SteadyState State(const Simulation& simulation) const {
    SteadyState state;
    state.wheel = simulation.Wheel(0);
    for (double softsoilWheel::*part : kMeans) state.wheel.*part = sum_.*part / steps_;
    state.sunk_volume = sunk_volume_;
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
  double sunk_volume_ = 0;  // [m^3]
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
  Driven(const BinDrive& drive, double load, Simulation* simulation)
      : drive_(drive), load_(load), simulation_(simulation) {}

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
    Window window;
    long samples = 0;
    for (long step = 1; step <= steps; ++step) {
      StepUnlessSunk(load_, simulation_);
      window.Add(simulation_->Wheel(0));
      for (; samples < kSamples * step / steps; ++samples) {
        const std::vector<softsoilContact> contacts = simulation_->Contacts(0);
        window.AddContact(contacts, SunkVolume(*simulation_, contacts, before.grid_spacing));
      }
    }
    SteadyState state = window.State(*simulation_);
    const softsoilGround after = simulation_->Ground();
    const double rut = after.rut_volume - before.rut_volume;
    const double displaced = after.displaced_volume - before.displaced_volume;
    const double compacted = rut - displaced;
    state.compacted_share = compacted > kRounding * rut ? compacted / rut : 0;
    return state;
  }

 private:
  const BinDrive& drive_;
  double load_;  // [N]
  Simulation* simulation_;
};

}  // namespace

void StepUnlessSunk(double load, Simulation* simulation) {
  simulation->Step();
  if (simulation->Wheel(0).centre[2] > 0) return;
  throw InputError("--load: the soil cannot carry " + Shown(load) +
                   " N on this tire: the wheel sinks to its axle");
}

void Settle(double load, Simulation* simulation) {
  double at_rest_since = 0;  // [s]
  while (simulation->Time() < kLongestSettling) {
    StepUnlessSunk(load, simulation);
    const double time = simulation->Time();
    if (std::abs(simulation->Wheel(0).load - load) > kLoadError * load) at_rest_since = time;
    if (time > kShortestSettling && time - at_rest_since > kAtRest) return;
  }
}

SteadyState DriveToSteadyState(const BinDrive& drive, double radius, double load,
                               Simulation* simulation) {
  if (!drive.spin) simulation->RemoveDamper(kSpin);
  Settle(load, simulation);
  const double start = simulation->Wheel(0).centre[0];
  Driven driven(drive, load, simulation);
  driven.Ramp();
  const double speed = drive.speed ? *drive.speed : *drive.spin * radius;
  const double window = std::max(kShortestWindow, kWindowPerRadius * radius / speed);
  SteadyState before = driven.Through(window), now;
  for (int k = 1; k < kMostWindows && !now.steady; ++k) {
    now = driven.Through(window);
    now.steady = IsSteady(before.wheel, now.wheel, load);
    before = now;
  }
  now.distance = now.wheel.centre[0] - start;
  return now;
}

}  // namespace softsoil
