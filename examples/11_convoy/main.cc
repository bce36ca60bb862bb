// A column of vehicles in one rut. They are alike and do not touch, so one is driven again and
// again: qpos and qvel are put back where the test track begins, time runs on, and the ground
// stays as the vehicle before has left it. Writes vehicles.csv and profiles.csv:
// convoy MODEL.xml SETTINGS VEHICLES FOLDER
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>

#include "../host.h"

namespace {

constexpr double kSpeed = 4;             // [m/s]
constexpr double kAcceleration = 1.5;    // [m/s^2]  of the first vehicle, from rest
constexpr double kGain = 8000;           // [N m s/m]  drive torque per speed that is missing
constexpr double kSettle = 1;            // [s]
constexpr double kStart = 8, kEnd = 17;  // [m]  the test track
constexpr double kSection = 14;          // [m]  where profiles are taken
constexpr int kStepsPerRow = 10;

struct Motion {
  std::vector<mjtNum> qpos, qvel;
};

void Step(const mjModel* m, mjData* d) {
  static const int drive = mj_name2id(m, mjOBJ_ACTUATOR, "drive");
  const double speed = std::fmin(kSpeed, kAcceleration * std::fmax(0, d->time - kSettle));
  d->ctrl[drive] = kGain * (speed - d->qvel[0]);
  mj_step(m, d);
}

Motion MotionOf(const mjModel* m, const mjData* d) {
  return {{d->qpos, d->qpos + m->nq}, {d->qvel, d->qvel + m->nv}};
}

void PutBack(const Motion& motion, mjData* d) {
  mju_copy(d->qpos, motion.qpos.data(), motion.qpos.size());
  mju_copy(d->qvel, motion.qvel.data(), motion.qvel.size());
}

// The vehicle as a whole; the rut is the one behind its last two wheels.
void WriteRow(const mjData* d, int vehicle, std::ostream& table) {
  double resistance = 0, torque = 0, rut = 0;
  const int wheels = softsoil_wheel_count(d);
  for (int i = 0; i < wheels; ++i) {
    softsoilWheel wheel;
    Check(softsoil_wheel(d, i, &wheel));
    resistance += wheel.motion_resistance;
    torque += wheel.torque;
    if (i >= wheels - 2) rut += wheel.rut_depth / 2;
  }
  table << vehicle << ',' << d->qpos[0] << ',' << d->qpos[1] << ',' << d->qvel[0] << ',' << rut
        << ',' << resistance << ',' << torque << '\n';
}

void WriteProfile(const mjData* d, int vehicle, std::ostream& table) {
  for (double y = -1.5; y < 1.505; y += 0.025) {
    double height = 0;
    Check(softsoil_height(d, kSection, y, &height));
    table << vehicle << ',' << y << ',' << height << '\n';
  }
}

}  // namespace

int main(int argc, char** argv) {
  Require(argc == 5, "usage: convoy MODEL.xml SETTINGS VEHICLES FOLDER");
  const Model m = Load(argv[1]);
  const Data d = MakeData(m.get());
  Check(softsoil_attach(m.get(), d.get(), argv[2]));

  std::ofstream rows(std::string(argv[4]) + "/vehicles.csv");
  std::ofstream profiles(std::string(argv[4]) + "/profiles.csv");
  rows << "vehicle,x [m],y [m],speed [m/s],rut_depth [m],motion_resistance [N],torque [N m]\n";
  profiles << "vehicle,y [m],height [m]\n";
  while (d->qpos[0] < kStart) Step(m.get(), d.get());
  const Motion start = MotionOf(m.get(), d.get());
  for (int vehicle = 1; vehicle <= std::atoi(argv[3]); ++vehicle) {
    PutBack(start, d.get());
    for (int step = 0; d->qpos[0] < kEnd; ++step) {
      Step(m.get(), d.get());
      if (step % kStepsPerRow == 0) WriteRow(d.get(), vehicle, rows);
    }
    WriteProfile(d.get(), vehicle, profiles);
  }
  rows.flush();
  profiles.flush();
  Require(rows.good() && profiles.good(), "cannot write the tables");
}
