#include "plugin/cli/simulation.h"

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <limits>
#include <memory>
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

mjModel* Load(const std::string& file, const mjVFS* memory = nullptr) {
  char message[1000] = "";
  mjModel* model = mj_loadXML(file.c_str(), memory, message, sizeof message);
  if (model == nullptr) throw InputError(file + ": " + OnOneLine(message));
  if (*message != '\0') {
    std::fprintf(stderr, "softsoil: %s: %s\n", file.c_str(), OnOneLine(message).c_str());
  }
  return model;
}

mjModel* LoadText(const std::string& name, const std::string& mjcf) {
  const auto memory = std::make_unique<mjVFS>();  // 2 MB: too large for the stack
  mj_defaultVFS(memory.get());
  const std::string entry = "model.xml";
  if (mj_makeEmptyFileVFS(memory.get(), entry.c_str(), static_cast<int>(mjcf.size())) != 0) {
    throw std::runtime_error(name + ": cannot be kept in memory");
  }
  std::memcpy(memory->filedata[0], mjcf.data(), mjcf.size());
  const auto done = [](mjVFS* vfs) { mj_deleteVFS(vfs); };
  const std::unique_ptr<mjVFS, decltype(done)> freed(memory.get(), done);
  return At(name, [&] { return Load(entry, memory.get()); });
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

Simulation::Simulation(const std::string& name, const std::string& mjcf)
    : scene_file_(name), model_(LoadText(name, mjcf)), data_(mj_makeData(model_)) {}

Simulation::~Simulation() {
  softsoil_detach(model_, data_);
  mj_deleteData(data_);
  mj_deleteModel(model_);
}

void Simulation::GiveSoil(const std::string& settings) {
  if (softsoil_attach(model_, data_, settings.c_str()) == 0) return;
  throw InputError(scene_file_ + ": " + softsoil_error());
}

void Simulation::LoadState(const std::string& file) {
  if (softsoil_load_simulation(model_, data_, file.c_str()) == 0) return;
  throw InputError(softsoil_error());
}

void Simulation::SaveState(const std::string& file) const {
  Require(softsoil_save_simulation(model_, data_, file.c_str()));
}

std::uint64_t Simulation::StateHash() const {
  std::uint64_t hash = 0;
  Require(softsoil_hash(data_, &hash));
  return hash;
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
  controls.Apply(Time(), data_->ctrl);
  Step();
}

void Simulation::Step() {
  const double time = Time();
  mj_step(model_, data_);
  if (Diverged(*data_)) {
    throw std::runtime_error("the model diverged at " + Shown(time) +
                             " s of simulated time; a shorter time step may help");
  }
  if (softsoil_wheel_count(data_) < 0) throw std::runtime_error(softsoil_error());
}

void Simulation::SetControl(const char* actuator, double value) {
  data_->ctrl[IdOf(mjOBJ_ACTUATOR, actuator)] = value;
}

void Simulation::SetPosition(const char* joint, double position) {
  data_->qpos[model_->jnt_qposadr[IdOf(mjOBJ_JOINT, joint)]] = position;
}

void Simulation::SetDamper(const char* joint, double damping) {
  model_->dof_damping[model_->jnt_dofadr[IdOf(mjOBJ_JOINT, joint)]] = damping;
}

int Simulation::IdOf(mjtObj kind, const char* name) const {
  const int id = mj_name2id(model_, kind, name);
  if (id < 0) throw std::invalid_argument(scene_file_ + ": has no \"" + name + "\"");
  return id;
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
  for (std::size_t i = 0; i < wheels.size(); ++i) wheels[i] = Wheel(static_cast<int>(i));
  return wheels;
}

softsoilWheel Simulation::Wheel(int wheel) const {
  softsoilWheel result;
  Require(softsoil_wheel(data_, wheel, &result));
  return result;
}

std::vector<softsoilContact> Simulation::Contacts(int wheel) const {
  std::vector<softsoilContact> contacts;
  const auto append = [](void* user, const softsoilContact* contact) {
    static_cast<std::vector<softsoilContact>*>(user)->push_back(*contact);
  };
  Require(softsoil_visit_contacts(data_, wheel, append, &contacts));
  return contacts;
}

double Simulation::Height(double x, double y) const {
  double height = 0;
  Require(softsoil_height(data_, x, y, &height));
  return height;
}

softsoilGround Simulation::Ground() const {
  softsoilGround ground;
  Require(softsoil_ground(data_, &ground));
  return ground;
}

softsoilProfile Simulation::Profile() const {
  softsoilProfile profile;
  Require(softsoil_profile(data_, &profile));
  return profile;
}

void Simulation::VisitSurface(softsoilVisitor visit, void* user) const {
  Require(softsoil_visit_surface(data_, visit, user));
}

}  // namespace softsoil
