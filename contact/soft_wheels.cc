#include "contact/soft_wheels.h"

#include "contact/plastic_sinkage.h"

namespace softsoil {

SoftWheels::SoftWheels(const Soil& soil, const GroundSettings& settings,
                       UndisturbedHeight undisturbed, const std::vector<Tire>& tires)
    : undisturbed_(soil, settings, std::move(undisturbed), static_cast<int>(tires.size())),
      ground_(undisturbed_),
      plastic_(tires.size()) {
  for (const Tire& tire : tires) wheels_.emplace_back(tire, settings.grid_spacing);
}

void SoftWheels::Evaluate(int wheel, const TirePose& pose, double h, PatchForces* forces) const {
  wheels_[wheel].Evaluate(pose, ground_.surface(), ground_.soil(), h, forces);
}

void SoftWheels::Commit(const std::vector<TirePose>& poses, const std::vector<PatchForces>& forces,
                        double h) {
  // All that may fail comes first.
  for (int wheel = 0; wheel < size(); ++wheel) {
    if (ground_.settings().mode == SurfaceMode::kFlow) {
      PlasticSinkage(tire(wheel), poses[wheel], forces[wheel].patch, ground_.soil(),
                     &plastic_[wheel]);
    }
    ground_.Reserve(wheel, forces[wheel].surface, plastic_[wheel]);
  }

  slip_ = nullptr;
  for (int wheel = 0; wheel < size(); ++wheel) {
    wheels_[wheel].Commit(forces[wheel]);
    ground_.AddLoad(wheel, forces[wheel].surface, h);
    ground_.DeepenPlastic(wheel, plastic_[wheel]);
  }
  ground_.Pass(h);
}

SoftWheelsState SoftWheels::State() const { return {ground_, Slip()}; }

void SoftWheels::ShareSlip() { slip_ = Slip(); }

std::shared_ptr<const std::vector<SlipMemory>> SoftWheels::Slip() const {
  if (slip_ != nullptr) return slip_;
  auto slip = std::make_shared<std::vector<SlipMemory>>();
  for (const WheelContact& wheel : wheels_) slip->push_back(wheel.Slip());
  return slip;
}

SoftWheelsState SoftWheels::Undisturbed() const {
  return {undisturbed_, std::make_shared<std::vector<SlipMemory>>(wheels_.size())};
}

void SoftWheels::SetState(SoftWheelsState state) {
  ground_ = std::move(state.ground);
  for (std::size_t i = 0; i < wheels_.size(); ++i) wheels_[i].SetSlip((*state.slip)[i]);
  slip_ = std::move(state.slip);
}

SoftWheelsState SoftWheels::ReadState(StateReader& reader) const {
  SoftWheelsState state = Undisturbed();
  state.ground.Read(reader);
  std::vector<SlipMemory> slip;
  for (const WheelContact& wheel : wheels_) {
    slip.push_back(ReadSlipMemory(reader, wheel.nodes().size()));
  }
  state.slip = std::make_shared<std::vector<SlipMemory>>(std::move(slip));
  return state;
}

void Write(const SoftWheelsState& state, StateWriter& writer) {
  state.ground.Write(writer);
  for (const SlipMemory& slip : *state.slip) Write(slip, writer);
}

void SoftWheels::ForgetSlip() {
  for (WheelContact& wheel : wheels_) wheel.Reset();
  slip_ = nullptr;
}

}  // namespace softsoil
