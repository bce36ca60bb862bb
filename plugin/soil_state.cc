#include "plugin/soil_state.h"

#include <cmath>

namespace softsoil {
namespace {

void Write(const TirePose& pose, StateWriter& writer) {
  writer.PutBytes(pose.centre_w.data(), sizeof pose.centre_w);
  writer.PutBytes(pose.frame_w.data(), sizeof pose.frame_w);
  writer.PutBytes(pose.velocity_w.data(), sizeof pose.velocity_w);
  writer.PutBytes(pose.angular_velocity_w.data(), sizeof pose.angular_velocity_w);
}

TirePose ReadPose(StateReader& reader) {
  constexpr double kUnitError = 1e-6;  // of the axes of a frame
  TirePose pose;
  reader.GetFinite(pose.centre_w.data(), 3);
  reader.GetFinite(pose.frame_w.data(), 9);
  reader.GetFinite(pose.velocity_w.data(), 3);
  reader.GetFinite(pose.angular_velocity_w.data(), 3);
  reader.Require(pose.frame_w.isUnitary(kUnitError), "the frame of a wheel");
  reader.Require(pose.centre_w.cwiseAbs().maxCoeff() <= kFarthest, "the place of a wheel");
  return pose;
}

}  // namespace

void Write(const SoilState& state, StateWriter& writer) {
  Write(state.wheels, writer);
  state.watch.Write(writer);
  writer.Put(!state.pending.poses.empty());
  for (const TirePose& pose : state.pending.poses) Write(pose, writer);
  writer.Put(state.pending.h);
}

SoilState ReadSoilState(StateReader& reader, const SoftWheels& wheels,
                        const SoilState& undisturbed) {
  SoilState state = undisturbed;
  state.wheels = wheels.ReadState(reader);
  state.watch.Read(reader, state.plan->nq, state.plan->nv);
  const bool is_pending = reader.GetFlag();
  state.pending.poses.clear();
  for (int i = 0; is_pending && i < wheels.size(); ++i) {
    state.pending.poses.push_back(ReadPose(reader));
  }
  state.pending.h = reader.GetFinite();
  reader.Require(state.pending.h >= 0, "a time step");
  return state;
}

}  // namespace softsoil
