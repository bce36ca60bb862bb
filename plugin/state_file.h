// Files with the state of the soil of a mjData, and with that of the mjData itself if wanted.
#pragma once

#include <mujoco/mujoco.h>

#include <string>
#include <vector>

#include "plugin/mujoco_state.h"
#include "plugin/soil_state.h"

namespace softsoil {

// Version of the files; others are refused.
constexpr std::uint32_t kStateFileVersion = 3;

// A mjData and its model.
struct ModelData {
  const mjModel* m;
  const mjData* d;
};

// Complete or not at all: written under another name and renamed. `data` may be null: then the file
// holds the soil alone. Throws std::runtime_error if the file cannot be written.
void SaveState(const std::string& path, const SoilState& state, const ModelData* data);

// A soil state, and the mjData as it was saved.
struct SavedState {
  SoilState soil;
  MujocoState mujoco;  // empty if not asked for
};

// What was saved; the mjData only if `m`, its model, is not null. `undisturbed` is that of the soil
// that it is for, `wheels` are its wheels. Throws InputError that tells why if the file cannot be
// read, is damaged, or is of another soil, model or version.
SavedState LoadState(const std::string& path, const SoftWheels& wheels,
                     const SoilState& undisturbed, const mjModel* m);

// The same to and from the bytes of a file.
void WriteState(const SoilState& state, const ModelData* data, const StateWriter::Sink& sink);
SavedState ParseState(const std::vector<unsigned char>& bytes, const SoftWheels& wheels,
                      const SoilState& undisturbed, const mjModel* m);

}  // namespace softsoil
