// A MuJoCo model on soft soil: what a host does with the C API of softsoil.h.
#pragma once

#include <mujoco/mujoco.h>

#include <cstdint>
#include <string>
#include <vector>

#include "plugin/cli/controls.h"
#include "plugin/softsoil.h"

namespace softsoil {

class Simulation {
 public:
  // A model without soil. Throws InputError. MuJoCo compiles one model at a time: not to be called
  // by two threads at once.
  explicit Simulation(const std::string& scene_file);
  // The same from MJCF in memory, which messages call `name`.
  Simulation(const std::string& name, const std::string& mjcf);
  ~Simulation();
  Simulation(const Simulation&) = delete;
  Simulation& operator=(const Simulation&) = delete;

  const mjModel& model() const { return *model_; }
  double Time() const { return data_->time; }  // [s]
  std::vector<Actuator> Actuators() const;

  // Before any step. `settings` as for softsoil_attach(). Throws InputError.
  void GiveSoil(const std::string& settings);

  // The soil and MuJoCo's part of the simulation. LoadState(), before any step, throws InputError;
  // SaveState() throws std::runtime_error.
  void LoadState(const std::string& file);
  void SaveState(const std::string& file) const;
  // softsoil_hash()
  std::uint64_t StateHash() const;

  // Drives as the controls say and steps. Throws std::runtime_error if the model diverges or has
  // lost its soil.
  void Step(const Controls& controls);
  // The same with the controls as they are.
  void Step();

  // Sets the control of an actuator. Throws std::invalid_argument if there is none of that name.
  void SetControl(const char* actuator, double value);
  // Of a joint with one degree of freedom: its position [m] or [rad], before any step, and the
  // damping [N s/m] or [N m s]. Throw std::invalid_argument if there is none of that name.
  void SetPosition(const char* joint, double position);
  void SetDamper(const char* joint, double damping);

  // Makes the results of the wheels those of the present instant. Without it they are those of the
  // last evaluation, up to a time step ago. Has no influence on the motion.
  void EvaluateWheels();

  std::vector<softsoilWheel> Wheels() const;
  softsoilWheel Wheel(int wheel) const;
  // The nodes of a wheel in contact, at the last evaluation.
  std::vector<softsoilContact> Contacts(int wheel) const;
  // Height [m] of the surface.
  double Height(double x, double y) const;
  softsoilGround Ground() const;
  softsoilProfile Profile() const;
  void VisitSurface(softsoilVisitor visit, void* user) const;

 private:
  int IdOf(mjtObj kind, const char* name) const;

  std::string scene_file_;
  mjModel* model_;
  mjData* data_;
};

}  // namespace softsoil
