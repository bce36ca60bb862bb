#include "plugin/soil_plan.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <limits>
#include <string>
#include <string_view>

#include "plugin/log.h"
#include "plugin/rigid_contact.h"
#include "plugin/shapes.h"
#include "plugin/soil_regions.h"
#include "plugin/time_step.h"
#include "plugin/tire_choice.h"
#include "terrain/input_error.h"

namespace softsoil {
namespace {

template <class T>
std::size_t Hash(const T* data, int count, std::size_t seed) {
  const auto* bytes = reinterpret_cast<const char*>(data);
  const std::string_view view(bytes, count * sizeof(T));
  return seed * 31 + std::hash<std::string_view>()(view);
}

void SayWheels(const SoilPlan& plan, const Settings& settings) {
  std::string list;
  for (std::size_t i = 0; i < plan.wheels.size(); ++i) {
    list += (i == 0 ? "" : ", ") + plan.wheels[i].name + " (" + plan.tires[i].name + ")";
  }
  std::string regions;
  for (const RegionNames& names : settings.regions) {
    regions += ", \"" + names.soil + "\" in the region \"" + names.site + "\"";
  }
  Say("soil \"" + plan.soils[0].name + "\"" + regions + " under the wheels " +
      (!settings.wheels.empty() ? "named in the model: " : "found by their geoms and hinges: ") +
      list);
}

void WarnOfRigidContact(const mjModel* m, const SoilPlan& plan) {
  const std::string warning =
      RigidContactWarning(m, plan.ground.geom, plan.wheels, plan.remove_rigid_contact);
  if (!warning.empty()) Say("warning: " + warning);
}

// Two digits: an estimate claims no more.
std::string Roughly(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2g", value);
  return text;
}

// The estimate is good to a factor of two.
void WarnOfTimeStep(const mjModel* m, const SoilPlan& plan) {
  double longest = std::numeric_limits<double>::infinity();
  std::string wheel;
  for (std::size_t i = 0; i < plan.wheels.size(); ++i) {
    if (plan.wheels[i].joint < 0 || plan.tires[i].name == kRigidTire) continue;
    const double load = StaticLoad(m, plan.wheels, plan.wheels[i]);
    for (int k = 0; k < plan.soils.size(); ++k) {
      const double allowed = LongestStep(m, plan.wheels[i], plan.tires[i], plan.soils[k], load);
      if (allowed >= longest) continue;
      longest = allowed;
      wheel = plan.wheels[i].name;
    }
  }
  if (m->opt.timestep <= longest / 2) return;
  Say("warning: the time step " + Shown(m->opt.timestep) + " s is more than half of about " +
      Roughly(longest) + " s, the longest that tire and mass of wheel \"" + wheel +
      "\" allow; make it shorter");
}

// The grid must resolve the contact patch, whose length is some tenths of the radius.
void WarnOfGrid(const SoilPlan& plan) {
  const auto smaller = [](const Tire& a, const Tire& b) { return a.shape.radius < b.shape.radius; };
  const auto smallest = std::min_element(plan.tires.begin(), plan.tires.end(), smaller);
  const double radius = smallest->shape.radius;
  if (plan.terrain.grid_spacing <= radius / 4) return;
  Say("warning: softsoil_grid_spacing is " + Shown(plan.terrain.grid_spacing) +
      " m, more than a quarter of the smallest wheel radius, " + Shown(radius) +
      " m; make it finer");
}

// Between grid nodes the ground is bilinear: bumps need a few of them.
void WarnOfGrid(const GroundSettings& terrain, const NurbsBumps& bumps) {
  if (bumps.height == 0 || terrain.grid_spacing <= bumps.spacing / 4) return;
  Say("warning: softsoil_grid_spacing is " + Shown(terrain.grid_spacing) +
      " m, more than a quarter of the distance of the bumps, " + Shown(bumps.spacing) +
      " m; make it finer");
}

void RequireUsable(const mjOption& option) {
  if ((option.disableflags & mjDSBL_PASSIVE) != 0) {
    throw InputError(
        "<option> <flag passive>: must be \"enable\", got \"disable\"; MuJoCo then does not ask "
        "for the forces of the soil");
  }
  if (!(option.timestep > 0) || !std::isfinite(option.timestep)) {
    throw InputError("<option> timestep: must be > 0 s, got " + Shown(option.timestep));
  }
}

}  // namespace

std::size_t ContentOf(const mjModel* m) {
  const int sizes[] = {m->nq, m->nv, m->nbody, m->ngeom, m->nuserdata};
  std::size_t content = Hash(sizes, std::size(sizes), 0);
  content = Hash(m->names, m->nnames, content);
  content = Hash(m->text_data, m->ntextdata, content);
  content = Hash(m->numeric_data, m->nnumericdata, content);
  return Hash(m->tuple_objid, m->ntupledata, content);
}

SoilPlan MakePlan(const mjModel* m, const Settings& settings) {
  RequireUsable(m->opt);
  SoilPlan plan;
  plan.terrain = settings.terrain;
  plan.ground = FindGroundPlane(m, settings.ground);
  plan.soils = ChooseSoils(m, plan.ground, settings);
  plan.bumps = settings.bumps;
  plan.ground.height = WithBumps(plan.ground.height, plan.bumps);
  plan.wheels = FindWheels(m, settings.wheels, settings.shapes.empty());
  AddShapes(m, settings.shapes, &plan.wheels);
  plan.tires = ChooseTires(m, plan.wheels, settings);
  plan.is_wheels = GeomsOfWheels(m, plan.wheels);
  plan.remove_rigid_contact = settings.remove_rigid_contact;
  plan.history = static_cast<std::size_t>(settings.history * kMegabyte);
  plan.model_content = ContentOf(m);
  plan.nq = m->nq;
  plan.nv = m->nv;
  plan.nuserdata = m->nuserdata;
  SayWheels(plan, settings);
  WarnOfRigidContact(m, plan);
  WarnOfTimeStep(m, plan);
  WarnOfGrid(plan);
  WarnOfGrid(plan.terrain, settings.bumps);
  return plan;
}

}  // namespace softsoil
