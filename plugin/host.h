// softsoil's place in the MuJoCo of this process: its callbacks, and what becomes of errors in a
// program that knows nothing of softsoil.
//
// MuJoCo calls back in the middle of mj_step, from any thread, with a mjModel and a mjData of any
// age. The callbacks find the soil of that mjData in the registry and call it without any lock.
#pragma once

#include <mujoco/mujoco.h>

#include <memory>

#include "plugin/registry.h"

namespace softsoil {

// What to do when a model asks for soil and it cannot be made, or when soil fails during a step:
// end the program (by its own mju_user_error if it has set one), or say so and go on without soil.
// A program that attaches soil by itself goes on, and asks the C API.
enum class OnError { kStop, kContinue };

// Installs mjcb_passive, and a notice of freed memory by which a deleted mjData gives its soil
// back. Callbacks that are set already are called first. Throws InputError if there is no MuJoCo
// 2.2.2 in this process. May be called any number of times.
void InstallCallbacks();

// From now on every mjData whose model names a soil gets it, at its first step.
void LearnModels(OnError on_error);

// Gives a mjData the soil of a plan, in place of one it may have.
void GiveSoil(const mjModel* m, mjData* d, std::shared_ptr<const SoilPlan> plan);

// As after GiveSoil. Throws InputError if the mjData has no soil, or has it for another model.
void ResetSoil(const mjModel* m, mjData* d);

// From now on the mjData goes without soil.
void TakeSoil(const mjModel* m, mjData* d);

// Gives a mjData with soil a state of it; soil that was lost is there again. Throws InputError.
void RestoreSoil(mjData* d, const SoilState& state);

// Gives `dst` a state of the soil of `src`, and soil if it has none yet. Its xfrc_applied may be a
// copy of that of `src`, whose model may be gone: programs go on with copies of it. Throws
// InputError if it is not of the model of `src`; then nothing has changed.
void CopySoil(const Fingerprint& of_src, const mjData* src, const SoilState& state, mjData* dst);

}  // namespace softsoil
