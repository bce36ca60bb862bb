// A wheel that rolls over soil which compacts, and can be put back to where it was.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>

#include "tests/plugin/simulation.h"

namespace softsoil {

// On a coarse grid: little to compute, and tiles are new every few steps.
inline OneWheel WheelOnLooseSoil(int nuserdata = 0) {
  OneWheel model;
  model.custom = R"(<text name="softsoil_soil" data="upland_sandy_loam"/>
                    <numeric name="softsoil_grid_spacing" data="0.1"/>
                    <numeric name="softsoil_volume_height" data="0.1"/>
                    <numeric name="softsoil_volumes" data="5"/>)";
  model.others = "<size nuserdata=\"" + std::to_string(nuserdata) + "\"/>";
  return model;
}

// Height [m] by grid node, of those that have sunk.
using Heights = std::map<std::pair<double, double>, double>;

inline Heights HeightsOf(const mjData* d) {
  Heights heights;
  const auto visit = [](void* user, double x, double y, double height, double sinkage) {
    if (sinkage != 0) (*static_cast<Heights*>(user))[{x, y}] = height;
  };
  EXPECT_EQ(softsoil_visit_surface(d, visit, &heights), 0) << softsoil_error();
  return heights;
}

inline std::uint64_t HashOf(const mjData* d) {
  std::uint64_t hash = 0;
  EXPECT_EQ(softsoil_hash(d, &hash), 0) << softsoil_error();
  return hash;
}

struct DrivenWheel : Simulation {
  explicit DrivenWheel(const OneWheel& model = WheelOnLooseSoil(), const char* settings = nullptr)
      : Simulation(model, settings), saved(MakeData(m)) {
    d->qvel[0] = 4;
    Run(0.1);
    Save();
  }
  ~DrivenWheel() { softsoil_free_snapshot(snapshot); }

  void Save() {
    mj_copyData(saved.get(), m.get(), d.get());
    softsoil_free_snapshot(snapshot);
    snapshot = softsoil_snapshot(d.get());
    EXPECT_NE(snapshot, nullptr) << softsoil_error();
  }
  void PutBack() {
    mj_copyData(d.get(), m.get(), saved.get());
    EXPECT_EQ(softsoil_restore(d.get(), snapshot), 0) << softsoil_error();
  }
  void Step() { mj_step(m.get(), d.get()); }
  // The state of the soil as a number, `seconds` after it was saved.
  std::uint64_t Future(double seconds) {
    PutBack();
    Run(seconds);
    return HashOf(d.get());
  }

  Data saved;
  softsoilSnapshot* snapshot = nullptr;
};

}  // namespace softsoil
