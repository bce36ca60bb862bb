#include "plugin/cli/simulation.h"

#include <algorithm>
#include <cstdio>
#include <limits>
#include <stdexcept>

#include "terrain/input_error.h"

namespace softsoil {
namespace {

// MuJoCo breaks its messages into lines.
std::string OnOneLine(std::string message) {
  message.erase(message.find_last_not_of(" \n") + 1);
  std::replace(message.begin(), message.end(), '\n', ' ');
  return message;
}

mjModel* Load(const std::string& file) {
  char message[1000] = "";
  mjModel* model = mj_loadXML(file.c_str(), nullptr, message, sizeof message);
  if (model == nullptr) throw InputError(file + ": " + OnOneLine(message));
  if (*message != '\0') {
    std::fprintf(stderr, "softsoil: %s: %s\n", file.c_str(), OnOneLine(message).c_str());
  }
  return model;
}

void Require(int result) {
  if (result != 0) throw std::runtime_error(softsoil_error());
}

// MuJoCo answers numbers that are not finite or huge with a warning and a reset, of the state or of
// the controls.
bool Diverged(const mjData& data) {
  return data.warning[mjWARN_BADQPOS].number + data.warning[mjWARN_BADQVEL].number +
             data.warning[mjWARN_BADQACC].number + data.warning[mjWARN_BADCTRL].number >
         0;
}

}  // namespace

Simulation::Simulation(const std::string& scene_file)
    : scene_file_(scene_file), model_(Load(scene_file)), data_(mj_makeData(model_)) {}

Simulation::~Simulation() {
  softsoil_detach(model_, data_);
  mj_deleteData(data_);
  mj_deleteModel(model_);
}

void Simulation::GiveSoil(const std::string& settings) {
  if (softsoil_attach(model_, data_, settings.c_str()) == 0) return;
  throw InputError(scene_file_ + ": " + softsoil_error());
}

std::vector<Actuator> Simulation::Actuators() const {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  std::vector<Actuator> actuators;
  for (int i = 0; i < model_->nu; ++i) {
    const char* name = mj_id2name(model_, mjOBJ_ACTUATOR, i);
    const bool limited = model_->actuator_ctrllimited[i] != 0;
    const mjtNum* range = model_->actuator_ctrlrange + 2 * i;
    actuators.push_back({name != nullptr ? name : "", limited ? range[0] : -kInfinity,
                         limited ? range[1] : kInfinity});
  }
  return actuators;
}

void Simulation::Step(const Controls& controls) {
  const double time = Time();
  controls.Apply(time, data_->ctrl);
  mj_step(model_, data_);
  if (Diverged(*data_)) {
    throw std::runtime_error("the model diverged at " + Shown(time) +
                             " s of simulated time; a shorter time step may help");
  }
  if (softsoil_wheel_count(data_) < 0) throw std::runtime_error(softsoil_error());
}

// Position and velocity stage alone evaluate the passive forces; the solver, whose warm start would
// change, does not run. The position stage normalizes quaternions, and twice is not the same bits
// as once.
void Simulation::EvaluateWheels() {
  const std::vector<mjtNum> positions(data_->qpos, data_->qpos + model_->nq);
  mj_fwdPosition(model_, data_);
  mj_fwdVelocity(model_, data_);
  std::copy(positions.begin(), positions.end(), data_->qpos);
}

std::vector<softsoilWheel> Simulation::Wheels() const {
  std::vector<softsoilWheel> wheels(softsoil_wheel_count(data_));
  for (std::size_t i = 0; i < wheels.size(); ++i) {
    Require(softsoil_wheel(data_, static_cast<int>(i), &wheels[i]));
  }
  return wheels;
}

std::vector<softsoilContact> Simulation::Contacts(int wheel) const {
  std::vector<softsoilContact> contacts;
  const auto append = [](void* user, const softsoilContact* contact) {
    static_cast<std::vector<softsoilContact>*>(user)->push_back(*contact);
  };
  Require(softsoil_visit_contacts(data_, wheel, append, &contacts));
  return contacts;
}

softsoilGround Simulation::Ground() const {
  softsoilGround ground;
  Require(softsoil_ground(data_, &ground));
  return ground;
}

void Simulation::VisitSurface(softsoilVisitor visit, void* user) const {
  Require(softsoil_visit_surface(data_, visit, user));
}

}  // namespace softsoil
