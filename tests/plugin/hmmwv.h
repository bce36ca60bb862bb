// The HMMWV of models/ on soft soil, on ground as it would be if it had driven far.
#pragma once

#include <mujoco/mujoco.h>

#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>

#include "plugin/fence.h"
#include "plugin/softsoil.h"

namespace softsoil {

// With the first its wheels leave ruts without compacting a column; with the second, on stiff
// tires, columns compact.
constexpr const char* kSoils[] = {"soil=tilled_yolo_loam", "soil=lete_sand tire=auto"};

inline void RequireSuccess(int result) {
  if (result == 0) return;
  std::fprintf(stderr, "%s\n", softsoil_error());
  std::exit(EXIT_FAILURE);
}

class Hmmwv {
 public:
  explicit Hmmwv(const std::string& settings, int nuserdata = 0) : m_(LoadModel()) {
    m_->nuserdata = nuserdata;
    d_.reset(mj_makeData(m_.get()));
    RequireSuccess(softsoil_attach(m(), d(), settings.c_str()));
  }
  ~Hmmwv() {
    WaitForSoil();
    softsoil_detach(m(), d());
  }
  Hmmwv(const Hmmwv&) = delete;
  Hmmwv& operator=(const Hmmwv&) = delete;

  mjModel* m() const { return m_.get(); }
  mjData* d() const { return d_.get(); }
  Ground& ground() const { return SoilOf(d())->soft_wheels().ground(); }

  // Until no soil job is in flight, which holds memory.
  void WaitForSoil() const {
    softsoilGround ground = {};
    RequireSuccess(softsoil_ground(d(), &ground));
  }

  // Settles for half a second, then rolls at `speed` [m/s].
  void SetGoing(double speed) {
    Step(500);
    for (const char* spin : {"fl_spin", "fr_spin", "rl_spin", "rr_spin"}) {
      d_->qvel[m_->jnt_dofadr[mj_name2id(m(), mjOBJ_JOINT, spin)]] = speed / kRadius;
    }
    d_->qvel[0] = speed;
  }
  void Step(int steps) {
    while (steps-- > 0) mj_step(m(), d());
  }

 private:
  static constexpr double kRadius = 0.47;  // [m]  of the wheels
  struct Delete {
    void operator()(mjModel* m) const { mj_deleteModel(m); }
    void operator()(mjData* d) const { mj_deleteData(d); }
  };
  static mjModel* LoadModel() {
    char error[500] = "";
    mjModel* m =
        mj_loadXML(SOFTSOIL_SOURCE_DIR "/models/scenes/hmmwv_flat.xml", nullptr, error, 500);
    if (m != nullptr) return m;
    std::fprintf(stderr, "%s\n", error);
    std::exit(EXIT_FAILURE);
  }

  std::unique_ptr<mjModel, Delete> m_;
  std::unique_ptr<mjData, Delete> d_;
};

// Presses a tile of the ground in its middle: a sinkage by bearing, and a force that compacts the
// columns below if `compacts`. A tile takes the same memory however much of it is deformed, and the
// stress below real tracks would take minutes.
inline void Dent(Ground& ground, TileIndex tile, bool compacts) {
  const GridNode middle = NodeAt(tile, kTileSide * kTileSide / 2 + kTileSide / 2);
  const double dx = ground.settings().grid_spacing, period = ground.settings().soil_clock;
  const SurfaceForce force{{middle.i * dx, middle.j * dx, 0}, {0, 0, compacts ? -2000.0 : -1.0}};
  ground.AddLoad(0, {force}, period);
  ground.DeepenPlastic(0, {{middle, 0.05}});
  ground.Pass(period);
}

// As much of the ground, in a strip 4 m wide.
inline void DentArea(Ground& ground, double area, bool compacts) {
  const double side = kTileSide * ground.settings().grid_spacing;
  const int tiles = static_cast<int>(area / (side * side) + 0.5);
  for (int k = 0; k < tiles; ++k) Dent(ground, {k / 10, k % 10}, compacts);
}

// The two tracks of `length` [m] behind a HMMWV at the origin; each covers two tiles across.
inline void DentTracks(Ground& ground, double length, bool compacts) {
  const double side = kTileSide * ground.settings().grid_spacing;
  for (int i = 1; i * side < length; ++i) {
    for (int j : {-3, -2, 1, 2}) Dent(ground, {-i, j}, compacts);
  }
}

}  // namespace softsoil
