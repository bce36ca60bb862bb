// All wheels of a vehicle on one soft ground: the whole of softsoil without MuJoCo.
#pragma once

#include <memory>
#include <variant>
#include <vector>

#include "contact/mesh_contact.h"
#include "contact/wheel_contact.h"
#include "contact/wheel_report.h"
#include "terrain/ground.h"

namespace softsoil {

// All that the future of the wheels on their ground depends on. Copying it is cheap.
struct SoftWheelsState {
  Ground ground;
  std::shared_ptr<const std::vector<SlipMemory>> slip;  // by wheel
};

class SoftWheels {
 public:
  // One tire per wheel. Throws InputError if a setting is out of range.
  SoftWheels(const SoilMap& soils, const GroundSettings& settings, UndisturbedHeight undisturbed,
             const std::vector<Tire>& tires);

  int size() const { return static_cast<int>(wheels_.size()); }
  const Tire& tire(int wheel) const;
  const TireNodes& nodes(int wheel) const;
  Ground& ground() { return ground_; }
  const Ground& ground() const { return ground_; }

  // Forces on a wheel at a pose, if held for h [s]. A question: changes nothing.
  void Evaluate(int wheel, const TirePose& pose, double h, PatchForces* forces) const;

  // The time step of h [s] is accepted with these poses and forces, one per wheel: slip memory,
  // plastic sinkage and load enter the history, and simulated time passes. If memory runs out the
  // step is either not in the history at all, or it is and the tick of the soil clock is put off.
  void Commit(const std::vector<TirePose>& poses, const std::vector<PatchForces>& forces, double h);

  // Cheap after ShareSlip(), until the next step. From any number of threads.
  SoftWheelsState State() const;
  void ShareSlip();
  SoftWheelsState Undisturbed() const;
  void SetState(SoftWheelsState state);
  // What Write() wrote. Throws InputError.
  SoftWheelsState ReadState(StateReader& reader) const;

  // After a jump in time: the ground stays as it is, the wheels touch it anew.
  void ForgetSlip();

 private:
  using Contact = std::variant<WheelContact, MeshContact>;
  static Contact ContactOf(const Tire& tire, double spacing);
  // What a step is in the history, but for the time that passes.
  void Keep(const std::vector<TirePose>& poses, const std::vector<PatchForces>& forces, double h);

  std::shared_ptr<const std::vector<SlipMemory>> Slip() const;

  Ground undisturbed_;  // as just made
  Ground ground_;
  std::vector<Contact> wheels_;
  std::shared_ptr<const std::vector<SlipMemory>> slip_;  // theirs, if shared; else null
  std::vector<std::vector<NodeSinkage>> plastic_;        // scratch, by wheel
};

// Waits for the soil job in flight.
void Write(const SoftWheelsState& state, StateWriter& writer);

}  // namespace softsoil
