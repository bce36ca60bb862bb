#include "plugin/soil_identity.h"

#include <algorithm>

#include "contact/tire.h"
#include "terrain/input_error.h"
#include "terrain/state_stream.h"

namespace softsoil {
namespace {

class IdentityList {
 public:
  void Add(const std::string& name, const std::string& value) { list_.push_back({name, value}); }
  void Add(const std::string& name, double value) { Add(name, Shown(value)); }

  // All numbers of the attributes of a catalogue entry.
  template <class Entry>
  void AddEntry(const std::string& of, const std::vector<Attribute<Entry>>& attributes,
                Entry entry) {
    for (const Attribute<Entry>& a : attributes) {
      Add(of + " <" + a.element + "> " + a.name, a.field(entry));
    }
  }
  SoilIdentity Take() { return std::move(list_); }

 private:
  SoilIdentity list_;
};

void AddSoil(const Soil& soil, IdentityList* list) {
  list->Add("soil", soil.name);
  list->Add("bearing form", static_cast<int>(soil.bearing.form));
  list->AddEntry("soil", SoilAttributes(soil.bearing.form), soil);
  list->Add("shear form", static_cast<int>(soil.shear.form));
  list->Add("residual shear", soil.shear.residual);
  list->Add("angle of repose", AngleOfRepose(soil));
  list->Add("slip sinkage", soil.slip_sinkage);
  list->Add("unloading k_0", soil.unloading.k_0);
  list->Add("unloading A_u", soil.unloading.A_u);
  list->Add("moisture shift", soil.compaction.moisture_shift);
  for (const DensityLayer& layer : soil.layers) {
    list->Add("top of a layer", layer.top);
    list->Add("density of a layer", layer.density);
  }
}

// Nothing where one soil is everywhere.
void AddRegions(const std::vector<SoilRegion>& regions, IdentityList* list) {
  for (std::size_t i = 0; i < regions.size(); ++i) {
    const std::string of = "region " + std::to_string(i + 1);
    for (int k = 0; k < 2; ++k) {
      list->Add("centre of " + of, regions[i].centre[k]);
      list->Add("side of " + of, regions[i].half_sides(0, k));
      list->Add("side of " + of, regions[i].half_sides(1, k));
    }
    AddSoil(regions[i].soil, list);
  }
}

void AddGround(const SoilPlan& plan, IdentityList* list) {
  const GroundSettings& s = plan.terrain;
  list->Add("grid_spacing", s.grid_spacing);
  list->Add("volume_height", s.volume_height);
  list->Add("volumes", s.volumes);
  list->Add("clock", s.soil_clock);
  list->Add("sync", s.sync ? 1 : 0);
  list->Add("mode", s.mode == SurfaceMode::kFlow ? "flow" : "compaction");
  list->Add("stress", NameOf(s.stress));
  const NurbsBumps& b = plan.bumps;
  list->Add("bumps", b.height == 0
                         ? "none"
                         : Shown(b.height) + "," + Shown(b.spacing) + "," + std::to_string(b.seed));
  // A function cannot be compared; samples of it can.
  for (const double x : {-37.21, 0.0, 1.37}) {
    for (const double y : {-23.43, 0.0, 1.71}) {
      list->Add("undisturbed height at " + Shown(x) + ", " + Shown(y), plan.ground.height(x, y));
    }
  }
}

std::string ContentOf(const TriangleMesh& mesh) {
  StateWriter writer;
  for (const Eigen::Vector3d& vertex : mesh.vertices) writer.PutBytes(vertex.data(), sizeof vertex);
  for (const std::array<int, 3>& corners : mesh.triangles) {
    writer.PutBytes(corners.data(), sizeof corners);
  }
  return std::to_string(writer.Finish());
}

void AddWheel(const Wheel& wheel, const Tire& tire, IdentityList* list) {
  const std::string of = "tire of \"" + wheel.name + "\"";
  list->Add(of, tire.name);
  list->AddEntry(of, TireAttributes(), tire);
  list->Add(of + " crown radius", tire.shape.crown_radius);
  const Lugs& lugs = tire.shape.lugs;
  list->Add(of + " height of lugs", lugs.height);
  list->Add(of + " number of lugs", lugs.count);
  list->Add(of + " angle of lugs", lugs.angle);
  list->Add(of + " void share", lugs.void_share);
  list->Add(of + " stagger of lugs", lugs.stagger);
  list->Add(of + " mesh", tire.mesh != nullptr ? ContentOf(*tire.mesh) : "none");
  for (int k = 0; k < 3; ++k) {
    list->Add("centre of \"" + wheel.name + "\"", wheel.centre_b[k]);
    list->Add("axis of \"" + wheel.name + "\"", wheel.axis_b[k]);
  }
}

}  // namespace

SoilIdentity IdentityOf(const SoilPlan& plan) {
  IdentityList list;
  AddSoil(plan.soils[0], &list);
  AddGround(plan, &list);
  list.Add("nq", plan.nq);
  list.Add("nv", plan.nv);
  list.Add("number of wheels", plan.wheels.size());
  for (std::size_t i = 0; i < plan.wheels.size(); ++i) {
    AddWheel(plan.wheels[i], plan.tires[i], &list);
  }
  AddRegions(plan.soils.regions(), &list);
  return list.Take();
}

void RequireSame(const SoilIdentity& other, const SoilIdentity& here, const std::string& whose) {
  for (std::size_t i = 0; i < std::max(other.size(), here.size()); ++i) {
    const auto theirs = i < other.size() ? other[i] : std::make_pair(here[i].first, "none");
    const auto ours = i < here.size() ? here[i] : std::make_pair(other[i].first, "none");
    if (theirs == ours) continue;
    throw InputError(whose + " is of another soil: " + ours.first + " is " + ours.second +
                     " here, there " + (theirs.first == ours.first ? "" : theirs.first + " is ") +
                     theirs.second);
  }
}

}  // namespace softsoil
