// Files with the state of the soil of a mjData, and with that of the mjData itself if wanted.
#pragma once

#include <mujoco/mujoco.h>

#include <string>
#include <vector>

#include "plugin/soil_state.h"

namespace softsoil {

// Version of the files; others are refused.
constexpr std::uint32_t kStateFileVersion = 2;

// A mjData and its model.
struct ModelData {
  const mjModel* m;
  mjData* d;
};

// Complete or not at all: written under another name and renamed. `data` may be null: then the file
// holds the soil alone. Throws std::runtime_error if the file cannot be written.
void SaveState(const std::string& path, const SoilState& state, const ModelData* data);

// A soil state, and the mjData as it was saved if `data` is not null. `undisturbed` is that of the
// soil that it is for, `wheels` are its wheels. Throws InputError that tells why if the file cannot
// be read, is damaged, or is of another soil, model or version; nothing has changed then.
SoilState LoadState(const std::string& path, const SoftWheels& wheels, const SoilState& undisturbed,
                    const ModelData* data);

// The same to and from the bytes of a file.
void WriteState(const SoilState& state, const ModelData* data, const StateWriter::Sink& sink);
SoilState ParseState(const std::vector<unsigned char>& bytes, const SoftWheels& wheels,
                     const SoilState& undisturbed, const ModelData* data);

}  // namespace softsoil
