// A wheel that rolls over soil that compacts in the background, and what tells two such simulations
// apart to the bit.
#pragma once

#include <string>
#include <vector>

#include "tests/plugin/simulation.h"

namespace softsoil {

inline OneWheel CompactingWheel(int nuserdata = 0, const std::string& custom = "") {
  OneWheel model;
  model.timestep = "0.002";
  model.custom = R"(<text name="softsoil_soil" data="upland_sandy_loam"/>
                    <numeric name="softsoil_grid_spacing" data="0.05"/>
                    <numeric name="softsoil_volumes" data="10"/>
                    <numeric name="softsoil_threads" data="1"/>)" +
                 custom;
  model.others = "<size nuserdata=\"" + std::to_string(nuserdata) + "\"/>";
  return model;
}

inline std::uint64_t Hash(const mjData* d) {
  std::uint64_t hash = 0;
  EXPECT_EQ(softsoil_hash(d, &hash), 0) << softsoil_error();
  return hash;
}

inline void Step(const mjModel* m, mjData* d, int steps) {
  for (int i = 0; i < steps; ++i) mj_step(m, d);
}
inline void Step(Simulation& sim, int steps) { Step(sim.m.get(), sim.d.get(), steps); }

struct Moment {
  std::vector<double> motion, forces;
  std::uint64_t soil = 0;
  bool operator==(const Moment& other) const {
    return motion == other.motion && forces == other.forces && soil == other.soil;
  }
};

// After `steps` more and a look at the forces of then.
inline Moment After(int steps, const mjModel* m, mjData* d) {
  Step(m, d, steps);
  mj_forward(m, d);
  Moment moment;
  moment.motion.assign(d->qpos, d->qpos + m->nq);
  moment.motion.insert(moment.motion.end(), d->qvel, d->qvel + m->nv);
  moment.motion.push_back(d->time);
  moment.forces.assign(d->xfrc_applied, d->xfrc_applied + 6 * m->nbody);
  moment.soil = Hash(d);
  return moment;
}
inline Moment After(int steps, Simulation& sim) { return After(steps, sim.m.get(), sim.d.get()); }

// A simulation that does nothing but step.
inline Moment PlainRun(const OneWheel& model, int steps) {
  Simulation sim(model);
  return After(steps, sim);
}

inline Data CopyOf(const Simulation& sim) {
  Data d = MakeData(sim.m);
  mj_copyData(d.get(), sim.m.get(), sim.d.get());
  return d;
}

}  // namespace softsoil
