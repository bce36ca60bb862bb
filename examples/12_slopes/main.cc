// A vehicle drives at a constant speed of its wheels while the world tilts, until it comes to
// stand uphill, or runs away downhill. Tilting gravity instead of the ground gives every slope in
// one drive; loose soil does not feel it. Each wheel has a servo of its own, as with locked
// differentials. Writes a table: slopes MODEL.xml SETTINGS up|down TABLE.csv
#include <cmath>
#include <fstream>
#include <string>

#include "../host.h"

namespace {

constexpr double kSpin = 3.2;              // [rad/s]  of the wheels
constexpr double kGain = 5000;             // [N m s]  of each servo
constexpr double kStart = 1.5, kTilt = 4;  // [s]  the wheels begin to turn, the world to tilt
constexpr double kRate = 2.5;              // [deg/s]
constexpr double kSteepest = 60;           // [deg]
constexpr double kStands = 0.02;           // [m/s]
constexpr double kRunsAway = 3;            // [m/s]  twice the speed of the wheels
constexpr int kStepsPerRow = 10;

double Slope(double time) { return time < kTilt ? 0 : kRate * (time - kTilt); }  // [deg]

// Gravity of a ground that rises along x, or falls.
void Tilt(mjModel* m, double slope, bool up) {
  const double g = 9.81, angle = (up ? slope : -slope) * mjPI / 180;
  m->opt.gravity[0] = -g * std::sin(angle);
  m->opt.gravity[2] = -g * std::cos(angle);
}

void TurnWheels(const mjModel* m, mjData* d) {
  const double spin = d->time < kStart ? 0 : std::fmin(1, d->time - kStart) * kSpin;
  for (const char* name : {"fl_spin", "fr_spin", "rl_spin", "rr_spin"}) {
    const int dof = m->jnt_dofadr[mj_name2id(m, mjOBJ_JOINT, name)];
    d->qfrc_applied[dof] = kGain * (spin - d->qvel[dof]);
  }
}

void WriteRow(const mjData* d, std::ostream& table) {
  double load = 0, thrust = 0, resistance = 0, area = 0;
  for (int i = 0; i < softsoil_wheel_count(d); ++i) {
    softsoilWheel wheel;
    Check(softsoil_wheel(d, i, &wheel));
    load += wheel.load;
    thrust += wheel.thrust;
    resistance += wheel.motion_resistance;
    area += wheel.contact_area;
  }
  table << Slope(d->time) << ',' << d->qvel[0] << ',' << load << ',' << thrust << ',' << resistance
        << ',' << area << '\n';
}

}  // namespace

int main(int argc, char** argv) {
  Require(argc == 5, "usage: slopes MODEL.xml SETTINGS up|down TABLE.csv");
  const Model m = Load(argv[1]);
  const Data d = MakeData(m.get());
  Check(softsoil_attach(m.get(), d.get(), argv[2]));

  const bool up = std::string(argv[3]) == "up";
  std::ofstream table(argv[4]);
  table << "slope [deg],speed [m/s],load [N],thrust [N],motion_resistance [N],contact_area [m^2]\n";
  const auto ends = [&] {
    const double speed = d->qvel[0];
    return d->time > kTilt && (speed < kStands || speed > kRunsAway || Slope(d->time) > kSteepest);
  };
  for (int step = 0; !ends(); ++step) {
    Tilt(m.get(), Slope(d->time), up);
    TurnWheels(m.get(), d.get());
    mj_step(m.get(), d.get());
    if (d->time > kTilt && step % kStepsPerRow == 0) WriteRow(d.get(), table);
  }
  table.flush();
  Require(table.good(), "cannot write the table");
}
