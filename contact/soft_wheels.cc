#include "contact/soft_wheels.h"

#include "contact/mesh_sinkage.h"
#include "contact/plastic_sinkage.h"

namespace softsoil {

SoftWheels::SoftWheels(const SoilMap& soils, const GroundSettings& settings,
                       UndisturbedHeight undisturbed, const std::vector<Tire>& tires)
    : undisturbed_(soils, settings, std::move(undisturbed), static_cast<int>(tires.size())),
      ground_(undisturbed_),
      plastic_(tires.size()) {
  for (const Tire& tire : tires) wheels_.push_back(ContactOf(tire, settings.grid_spacing));
}

SoftWheels::Contact SoftWheels::ContactOf(const Tire& tire, double spacing) {
  if (tire.mesh != nullptr) return MeshContact(tire, spacing);
  return WheelContact(tire, spacing);
}

const Tire& SoftWheels::tire(int wheel) const {
  return std::visit([](const auto& contact) -> const Tire& { return contact.tire(); },
                    wheels_[wheel]);
}

const TireNodes& SoftWheels::nodes(int wheel) const {
  return std::visit([](const auto& contact) -> const TireNodes& { return contact.nodes(); },
                    wheels_[wheel]);
}

void SoftWheels::Evaluate(int wheel, const TirePose& pose, double h, PatchForces* forces) const {
  const Stopwatch stopwatch(&ground_.Times(), Work::kContact);
  std::visit(
      [&](const auto& contact) {
        contact.Evaluate(pose, ground_.surface(), ground_.soils(), h, forces);
      },
      wheels_[wheel]);
}

void SoftWheels::Commit(const std::vector<TirePose>& poses, const std::vector<PatchForces>& forces,
                        double h) {
  Keep(poses, forces, h);
  ground_.Pass(h);
}

void SoftWheels::Keep(const std::vector<TirePose>& poses, const std::vector<PatchForces>& forces,
                      double h) {
  const Stopwatch stopwatch(&ground_.Times(), Work::kContact);
  // All that may fail comes first.
  for (int wheel = 0; wheel < size(); ++wheel) {
    if (ground_.settings().mode == SurfaceMode::kFlow) {
      const auto sink = tire(wheel).mesh != nullptr ? PlasticSinkageOfMesh : PlasticSinkage;
      sink(tire(wheel), poses[wheel], forces[wheel].patch, ground_.soils(), &plastic_[wheel]);
    }
    ground_.Reserve(wheel, forces[wheel].surface, plastic_[wheel]);
  }

  slip_ = nullptr;
  for (int wheel = 0; wheel < size(); ++wheel) {
    std::visit([&](auto& contact) { contact.Commit(forces[wheel]); }, wheels_[wheel]);
    ground_.AddLoad(wheel, forces[wheel].surface, h);
    ground_.DeepenPlastic(wheel, plastic_[wheel]);
  }
}

SoftWheelsState SoftWheels::State() const { return {ground_, Slip()}; }

void SoftWheels::ShareSlip() { slip_ = Slip(); }

std::shared_ptr<const std::vector<SlipMemory>> SoftWheels::Slip() const {
  if (slip_ != nullptr) return slip_;
  auto slip = std::make_shared<std::vector<SlipMemory>>();
  for (const Contact& wheel : wheels_) {
    slip->push_back(std::visit([](const auto& contact) { return contact.Slip(); }, wheel));
  }
  return slip;
}

SoftWheelsState SoftWheels::Undisturbed() const {
  return {undisturbed_, std::make_shared<std::vector<SlipMemory>>(wheels_.size())};
}

void SoftWheels::SetState(SoftWheelsState state) {
  ground_ = std::move(state.ground);
  for (std::size_t i = 0; i < wheels_.size(); ++i) {
    std::visit([&](auto& contact) { contact.SetSlip((*state.slip)[i]); }, wheels_[i]);
  }
  slip_ = std::move(state.slip);
}

SoftWheelsState SoftWheels::ReadState(StateReader& reader) const {
  SoftWheelsState state = Undisturbed();
  state.ground.Read(reader);
  std::vector<SlipMemory> slip;
  for (int wheel = 0; wheel < size(); ++wheel) {
    slip.push_back(ReadSlipMemory(reader, nodes(wheel).size()));
  }
  state.slip = std::make_shared<std::vector<SlipMemory>>(std::move(slip));
  return state;
}

void Write(const SoftWheelsState& state, StateWriter& writer) {
  state.ground.Write(writer);
  for (const SlipMemory& slip : *state.slip) Write(slip, writer);
}

void SoftWheels::ForgetSlip() {
  for (Contact& wheel : wheels_) {
    std::visit([](auto& contact) { contact.Reset(); }, wheel);
  }
  slip_ = nullptr;
}

}  // namespace softsoil
