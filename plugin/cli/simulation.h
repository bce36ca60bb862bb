// A MuJoCo model on soft soil: what a host does with the C API of softsoil.h.
#pragma once

#include <mujoco/mujoco.h>

#include <string>
#include <vector>

#include "plugin/cli/controls.h"
#include "plugin/softsoil.h"

namespace softsoil {

class Simulation {
 public:
  // A model without soil. Throws InputError.
  explicit Simulation(const std::string& scene_file);
  ~Simulation();
  Simulation(const Simulation&) = delete;
  Simulation& operator=(const Simulation&) = delete;

  const mjModel& model() const { return *model_; }
  double Time() const { return data_->time; }  // [s]
  std::vector<Actuator> Actuators() const;

  // Before any step. `settings` as for softsoil_attach(). Throws InputError.
  void GiveSoil(const std::string& settings);

  // Drives as the controls say and steps. Throws std::runtime_error if the model diverges or has
  // lost its soil.
  void Step(const Controls& controls);

  // Makes the results of the wheels those of the present instant. Without it they are those of the
  // last evaluation, up to a time step ago. Has no influence on the motion.
  void EvaluateWheels();

  std::vector<softsoilWheel> Wheels() const;
  std::vector<softsoilContact> Contacts(int wheel) const;
  softsoilGround Ground() const;
  void VisitSurface(softsoilVisitor visit, void* user) const;

 private:
  std::string scene_file_;
  mjModel* model_;
  mjData* data_;
};

}  // namespace softsoil
