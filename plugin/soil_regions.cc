#include "plugin/soil_regions.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "plugin/model_geometry.h"
#include "plugin/models_folder.h"
#include "terrain/constants.h"
#include "terrain/input_error.h"

namespace softsoil {
namespace {

using Eigen::Vector3d;

constexpr double kMostTiltDegrees = 0.1;

int SiteWithName(const mjModel* m, const std::string& name) {
  for (int site = 0; site < m->nsite; ++site) {
    if (name == m->names + m->name_siteadr[site]) return site;
  }
  throw InputError("the model has no site \"" + name + "\"");
}

std::string TypeName(int type) {
  switch (type) {
    case mjGEOM_SPHERE: return "sphere";
    case mjGEOM_CAPSULE: return "capsule";
    case mjGEOM_ELLIPSOID: return "ellipsoid";
    case mjGEOM_CYLINDER: return "cylinder";
    default: return "type " + std::to_string(type);
  }
}

void RequireBoxOfTheWorld(const mjModel* m, int site, const std::string& in_words) {
  if (m->site_type[site] != mjGEOM_BOX) {
    throw InputError(in_words + " must be of type box, got " + TypeName(m->site_type[site]));
  }
  if (m->site_bodyid[site] != 0) {
    throw InputError(in_words + " must belong to the world body, got " +
                     BodyName(m, m->site_bodyid[site]));
  }
}

// What a box cuts out of the plane, seen from above.
SoilRegion RegionOf(const mjModel* m, const GroundPlane& ground, const std::string& site_name) {
  const int site = SiteWithName(m, site_name);
  const std::string in_words = "site \"" + site_name + "\"";
  RequireBoxOfTheWorld(m, site, in_words);
  const Frame box = FrameAt(m->site_pos + 3 * site, m->site_quat + 4 * site);
  const Vector3d half = Vector(m->site_size + 3 * site);

  if (!box.position.allFinite() || !box.orientation.allFinite() || !half.allFinite()) {
    throw InputError(in_words + " must have a finite place and size");
  }

  const double along = std::abs(box.orientation.col(2).dot(ground.normal_w));
  const double tilt = std::acos(std::min(1.0, along)) * kDegrees;
  if (tilt > kMostTiltDegrees) {
    throw InputError(in_words + " must stand upright on " + GeomName(m, ground.geom) +
                     ": its z axis at most " + Shown(kMostTiltDegrees) +
                     " degrees from the normal, got " + Shown(std::round(tilt * 1000) / 1000));
  }
  const double above = ground.normal_w.dot(box.position - ground.point_w);
  if (std::abs(above) > half.z()) {
    throw InputError(in_words + " must cut " + GeomName(m, ground.geom) +
                     ": its centre at most its half height " + Shown(half.z()) + " m away, got " +
                     Shown(std::abs(above)));
  }
  SoilRegion region;
  region.centre = (box.position - above * ground.normal_w).head<2>();
  for (int k : {0, 1}) region.half_sides.col(k) = half[k] * box.orientation.col(k).head<2>();
  return region;
}

}  // namespace

SoilMap ChooseSoils(const mjModel* m, const GroundPlane& ground, const Settings& settings) {
  const auto catalogue = SoilCatalogue().With(ModelsFolder() + "/soils", settings.soil_files);
  const Soil everywhere = At("softsoil_soil", [&] { return catalogue.Find(settings.soil); });
  return At("softsoil_regions", [&] {
    std::vector<SoilRegion> regions;
    for (const RegionNames& names : settings.regions) {
      regions.push_back(RegionOf(m, ground, names.site));
      regions.back().soil =
          At("site \"" + names.site + "\"", [&] { return catalogue.Find(names.soil); });
    }
    return SoilMap(everywhere, regions);
  });
}

}  // namespace softsoil
