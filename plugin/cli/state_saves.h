// The states that softsoil run saves on its way.
#pragma once

#include <string>
#include <vector>

namespace softsoil {

struct StateSave {
  double time;       // [s]  simulated
  std::string file;  // with softsoil_save_simulation()
};

// Of a text T:FILE. Throws InputError.
StateSave StateSaveIn(const std::string& text);

// Throws InputError unless every file can be written: its folder is there or is `folder`, which the
// run makes, and all that it replaces is an older state, none of the `inputs`, and nothing that the
// run itself writes, such as `results` in `folder`.
void RequirePlaces(const std::vector<StateSave>& saves, const std::string& folder,
                   const std::vector<std::string>& results, const std::vector<std::string>& inputs);

// Takes away what an earlier run has left under these names: it would be taken for the states of a
// run that is killed.
void RemoveOlder(const std::vector<StateSave>& saves);

}  // namespace softsoil
