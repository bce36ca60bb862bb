// The C interface: soil given and taken, and its results.
#include <memory>
#include <string>

#include "contact/patch_report.h"
#include "plugin/fence.h"
#include "plugin/host.h"
#include "plugin/softsoil.h"
#include "terrain/limits.h"

namespace {

using softsoil::EntryOf;
using softsoil::Fenced;
using softsoil::InputError;
using softsoil::Require;
using softsoil::RunningSoilOf;
using softsoil::Settings;
using softsoil::SoilBinding;
using softsoil::SoilOf;

// Grid nodes are numbered with 32 bits.
void RequirePlace(const char* name, double value) {
  constexpr softsoil::Limits kPlaces = {-softsoil::kFarthest, softsoil::kFarthest};  // [m]
  if (Contains(kPlaces, value)) return;
  throw InputError(std::string(name) + " must be " + InWords(kPlaces) + " m, got " +
                   softsoil::Shown(value));
}

void Copy(const Eigen::Vector3d& from, double* to) {
  for (int k = 0; k < 3; ++k) to[k] = from[k];
}

void RequireWheel(const SoilBinding& soil, int wheel) {
  const int count = soil.soft_wheels().size();
  if (wheel >= 0 && wheel < count) return;
  throw InputError("wheel must be 0 to " + std::to_string(count - 1) + ", got " +
                   std::to_string(wheel));
}

softsoilWheel WheelResult(SoilBinding& soil, int wheel) {
  const softsoil::Wheel& known = soil.plan().wheels[wheel];
  const softsoil::TirePose& pose = soil.pose(wheel);
  const softsoil::PatchForces& forces = soil.forces(wheel);
  const softsoil::WheelReport report = ReportOf(soil.soft_wheels().tire(wheel), pose, forces);
  const softsoil::CompactionWork& work = soil.soft_wheels().ground().Work(wheel);

  softsoilWheel result = {};
  result.name = known.name.c_str();
  result.body = known.body;
  result.load = report.load;
  result.sinkage = report.sinkage;
  result.rut_depth = report.rut_depth;
  result.slip_ratio = report.slip_ratio;
  result.slip_angle = report.slip_angle;
  result.camber = report.camber;
  result.spin = report.spin;
  result.forward_speed = report.forward_speed;
  result.thrust = report.thrust;
  result.motion_resistance = report.motion_resistance;
  result.drawbar_pull = report.drawbar_pull;
  result.lateral_force = report.lateral_force;
  result.torque = report.torque;
  result.contact_area = report.contact_area;
  result.mean_pressure = report.mean_pressure;
  result.peak_pressure = report.peak_pressure;
  result.compaction_energy = work.energy;
  result.compaction_power = work.power;
  Copy(pose.centre_w, result.centre);
  Copy(forces.wrench.force_w, result.force);
  Copy(forces.wrench.torque_w, result.torque_at_centre);
  return result;
}

softsoilContact ContactResult(const softsoil::PatchPoint& point) {
  softsoilContact result = {};
  Copy(point.position_w, result.position);
  Copy(point.normal_force_w, result.normal_force);
  Copy(point.shear_force_w, result.shear_force);
  result.angle = point.angle;
  result.lateral = point.lateral;
  result.pressure = point.pressure;
  result.shear = point.shear;
  result.shear_across = point.shear_across;
  result.area = point.area;
  result.depth = point.depth;
  return result;
}

softsoilGround GroundResult(const SoilBinding& soil) {
  const softsoil::Ground& ground = soil.soft_wheels().ground();
  softsoilGround result = {};
  result.soil = soil.plan().soils[0].name.c_str();
  result.grid_spacing = ground.settings().grid_spacing;
  result.soil_clock = ground.settings().soil_clock;
  result.threads = ground.settings().threads;
  result.columns = ground.ColumnCount();
  result.volumes = ground.VolumeCount();
  result.bytes = ground.ColumnBytes();
  result.volume_bytes = ground.VolumeBytes();
  result.rut_volume = ground.surface().RutVolume();
  result.displaced_volume = ground.surface().DisplacedVolume();
  result.densified_volume = ground.surface().CompactionVolume();
  result.berm_volume = ground.surface().BermVolume();
  result.stress = softsoil::NameOf(ground.settings().stress);
  result.direct_updates = ground.stress_updates().direct;
  result.gaussian_updates = ground.stress_updates().gaussian;
  return result;
}

}  // namespace

extern "C" {

const char* softsoil_version(void) { return SOFTSOIL_VERSION; }

const char* softsoil_error(void) { return softsoil::LastError().c_str(); }

int softsoil_attach(const mjModel* m, mjData* d, const char* settings) {
  return Fenced([&] {
    Require(m, "mjModel");
    Require(d, "mjData");
    Settings chosen = softsoil::SettingsOf(m);
    if (settings != nullptr) softsoil::Override(settings, &chosen);
    if (chosen.soil.empty()) {
      throw InputError("softsoil_soil: the model or the settings must name a soil");
    }
    softsoil::InstallCallbacks();
    softsoil::GiveSoil(m, d, std::make_shared<softsoil::SoilPlan>(softsoil::MakePlan(m, chosen)));
  });
}

int softsoil_detach(const mjModel* m, mjData* d) {
  return Fenced([&] {
    Require(m, "mjModel");
    EntryOf(d);
    softsoil::TakeSoil(m, d);
  });
}

int softsoil_reset(const mjModel* m, mjData* d) {
  return Fenced([&] {
    Require(m, "mjModel");
    EntryOf(d);
    softsoil::ResetSoil(m, d);
  });
}

int softsoil_wheel_count(const mjData* d) {
  int count = -1;
  Fenced([&] { count = RunningSoilOf(d)->soft_wheels().size(); });
  return count;
}

int softsoil_wheel(const mjData* d, int wheel, softsoilWheel* result) {
  return Fenced([&] {
    Require(result, "result");
    const std::shared_ptr<SoilBinding> soil = RunningSoilOf(d);
    RequireWheel(*soil, wheel);
    *result = WheelResult(*soil, wheel);
  });
}

int softsoil_visit_contacts(const mjData* d, int wheel, softsoilContactVisitor visit, void* user) {
  return Fenced([&] {
    const std::shared_ptr<SoilBinding> soil = RunningSoilOf(d);
    RequireWheel(*soil, wheel);
    if (visit == nullptr) throw InputError("visit must not be NULL");
    for (const softsoil::PatchPoint& point :
         PatchReportOf(soil->soft_wheels().nodes(wheel), soil->pose(wheel), soil->forces(wheel))) {
      const softsoilContact contact = ContactResult(point);
      visit(user, &contact);
    }
  });
}

int softsoil_height(const mjData* d, double x, double y, double* height) {
  return Fenced([&] {
    Require(height, "height");
    RequirePlace("x", x);
    RequirePlace("y", y);
    *height = SoilOf(d)->soft_wheels().ground().surface().Height(x, y);
  });
}

int softsoil_ground(const mjData* d, softsoilGround* result) {
  return Fenced([&] {
    Require(result, "result");
    *result = GroundResult(*SoilOf(d));
  });
}

int softsoil_profile(const mjData* d, softsoilProfile* result) {
  return Fenced([&] {
    Require(result, "result");
    using softsoil::Work;
    const softsoil::WallTimes& times = SoilOf(d)->soft_wheels().ground().Times();
    *result = {times.Of(Work::kContact), times.Of(Work::kFlow), times.Of(Work::kWaiting),
               times.Of(Work::kStress), times.Of(Work::kCompaction)};
  });
}

int softsoil_visit_surface(const mjData* d, softsoilVisitor visit, void* user) {
  return Fenced([&] {
    const std::shared_ptr<SoilBinding> soil = SoilOf(d);
    if (visit == nullptr) throw InputError("visit must not be NULL");
    const softsoil::Surface& surface = soil->soft_wheels().ground().surface();
    surface.ForEachNode([&](softsoil::GridNode node, double height, double sinkage) {
      visit(user, node.i * surface.spacing(), node.j * surface.spacing(), height, sinkage);
    });
  });
}

}  // extern "C"
