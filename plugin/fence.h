// The fence around the C interface: what is thrown inside becomes -1 and softsoil_error().
#pragma once

#include <mujoco/mujoco.h>

#include <exception>
#include <memory>
#include <string>

#include "plugin/out_of_memory.h"
#include "plugin/registry.h"
#include "terrain/input_error.h"

namespace softsoil {

// Of the last call that failed on this thread.
std::string& LastError();

template <class Body>
int Fenced(const Body& body) {
  try {
    LastError().clear();
    body();
    return 0;
  } catch (const std::exception& error) {
    Keep(MessageOf(error), &LastError());
  } catch (...) {
    LastError() = "unknown error";
  }
  return -1;
}

inline void Require(const void* argument, const char* name) {
  if (argument == nullptr) throw InputError(std::string(name) + " must not be NULL");
}

// The entry of a mjData that has soil, also one that rests after a failure. Throws InputError.
std::shared_ptr<SoilEntry> EntryOf(const mjData* d);
// The same; throws InputError besides if the mjData is of another model, whose sizes differ.
std::shared_ptr<SoilEntry> EntryOf(const mjModel* m, const mjData* d);
// The soil in it, in the state that the mark in the mjData names; whoever holds the result keeps it
// alive. Throws InputError besides if that state is no longer held.
std::shared_ptr<SoilBinding> SoilOf(const mjData* d);
// Throws std::runtime_error besides if the soil rests.
std::shared_ptr<SoilBinding> RunningSoilOf(const mjData* d);

}  // namespace softsoil
