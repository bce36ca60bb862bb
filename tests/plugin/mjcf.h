// Models and simulations for tests, made from MJCF strings.
#pragma once

#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <cstring>
#include <memory>
#include <string>

namespace softsoil {

struct DeleteModel {
  void operator()(mjModel* m) const { mj_deleteModel(m); }
};
struct DeleteData {
  void operator()(mjData* d) const { mj_deleteData(d); }
};
using Model = std::unique_ptr<mjModel, DeleteModel>;
using Data = std::unique_ptr<mjData, DeleteData>;

inline Model Load(const std::string& mjcf) {
  static mjVFS files;
  mj_defaultVFS(&files);
  mj_makeEmptyFileVFS(&files, "model.xml", static_cast<int>(mjcf.size()));
  std::memcpy(files.filedata[0], mjcf.data(), mjcf.size());
  char error[500] = "";
  Model model(mj_loadXML("model.xml", &files, error, sizeof error));
  mj_deleteVFS(&files);
  EXPECT_NE(model, nullptr) << error << "\n" << mjcf;
  return model;
}

inline Data MakeData(const Model& m) { return Data(mj_makeData(m.get())); }

inline void ExpectNoWarnings(const Data& d) {
  for (int i = 0; i < mjNWARNING; ++i) {
    EXPECT_EQ(d->warning[i].number, 0) << mju_warningText(i, d->warning[i].lastinfo);
  }
}

// <worldbody> around `bodies`, beside other elements.
inline std::string World(const std::string& bodies, const std::string& others = "") {
  return "<mujoco>" + others + "<worldbody>" + bodies + "</worldbody></mujoco>";
}

}  // namespace softsoil
