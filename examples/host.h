// What the programs of the examples share: a simulation that frees itself, and an end with a
// message where a call fails.
#pragma once

#include <softsoil/softsoil.h>

#include <cstdio>
#include <cstdlib>
#include <memory>

struct Free {
  const mjModel* m;
  void operator()(mjData* d) const {
    softsoil_detach(m, d);
    mj_deleteData(d);
  }
};
using Model = std::unique_ptr<mjModel, decltype(&mj_deleteModel)>;
using Data = std::unique_ptr<mjData, Free>;

inline void Require(bool holds, const char* message) {
  if (holds) return;
  std::fprintf(stderr, "%s\n", message);
  std::exit(1);
}

// The result of a call of softsoil.
inline void Check(int result) { Require(result == 0, softsoil_error()); }

inline Model Load(const char* file) {
  char error[1000] = "";
  Model m(mj_loadXML(file, nullptr, error, sizeof error), &mj_deleteModel);
  Require(m != nullptr, error);
  return m;
}

inline Data MakeData(const mjModel* m) { return Data(mj_makeData(m), Free{m}); }
