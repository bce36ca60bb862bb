// The soil bin of Madsen (2014), 6.3.1, for any tire and load: a quarter car of three bodies that
// drives straight ahead. Made from the shipped scene soil_bin.xml, which says how it works.
//
// Sprung mass, spindle and wheel keep their shares of the mass: 90, 5 and 5 %. Suspension stiffness
// and damping grow with the mass, so the frequency and the damping ratio of the sprung mass stay,
// and lengths with the tire. The servos grow with the load: a force or a moment per radius as
// large as the load costs 1e-6 m/s.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "contact/tire.h"

namespace softsoil {

enum class BinMode {
  kSlip,    // forward speed and spin are prescribed
  kSpin,    // spin is prescribed, the rig is free to move ahead
  kTorque,  // the torque on the wheel is prescribed, the rig is free to move ahead
};

struct SoilBin {
  Tire tire;         // of a catalogue
  std::string soil;  // name in the catalogue
  double load = 0;   // [N]  > 0, weight of the rig
  BinMode mode = BinMode::kSlip;
  // Further settings of softsoil, without the prefix softsoil_.
  std::vector<std::pair<std::string, std::string>> settings;
};

// Names of the actuators in the model: a speed [m/s], a spin [rad/s], a torque [N m]. The first two
// are those of the joints too.
constexpr char kForward[] = "forward", kSpin[] = "spin", kTorque[] = "torque";
constexpr char kHeave[] = "heave";  // joint, upwards

// Damping of the servos.
constexpr double kServoPerLoad = 1e6;  // [N s/m per N], [N m s per N m]

// The model in MJCF. Throws std::runtime_error if the shipped scene is not what it was.
std::string SoilBinModel(const SoilBin& bin);

}  // namespace softsoil
