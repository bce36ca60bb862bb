#include "plugin/tire_choice.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "contact/flat_plate.h"
#include "contact/tire_family.h"
#include "plugin/log.h"
#include "plugin/models_folder.h"
#include "plugin/shapes.h"
#include "terrain/constants.h"
#include "terrain/input_error.h"

namespace softsoil {
namespace {

constexpr double kDeflection = 0.02;          // of the radius
constexpr double kDampingRatio = 0.1;         // of critical
constexpr double kSoilFriction = 0.65;        // rubber on soil, as the tires of the catalogue
constexpr double kRadiusTolerance = 0.05;     // between tire and geom
constexpr double kMeanPenetration = 2.0 / 3;  // of the deepest, under a round tire

TireShape Torus(double radius, double crown_radius, double half_width) {
  return {radius, crown_radius, 2 * std::min(half_width, crown_radius)};
}

TireShape ShapeOf(const Wheel& wheel) {
  const double r = wheel.radius, half = wheel.half_width;
  switch (wheel.outline) {
    case WheelOutline::kSphere: return Torus(r, r, r);
    // Of the ellipse the curvature at the tread; only a thick one is wider than that circle.
    case WheelOutline::kEllipsoid: return Torus(r, half * half / r, half);
    // A short capsule is a sphere, a long one a cylinder with round ends.
    case WheelOutline::kCapsule:
      if (half < r) return Torus(r, r, r);
      break;
    default: break;
  }
  return {r, std::numeric_limits<double>::infinity(), 2 * half};
}

void WarnOfRadius(const Wheel& wheel, const Tire& tire) {
  if (wheel.outline == WheelOutline::kUnknown) return;
  const double radius = tire.shape.radius;
  if (std::abs(radius - wheel.radius) <= kRadiusTolerance * wheel.radius) return;
  Say("warning: wheel \"" + wheel.name + "\": tire \"" + tire.name + "\" has the radius " +
      Shown(radius) + " m, the wheel's geom " + Shown(wheel.radius) + " m");
}

Catalogue<Tire> AllTires(const Settings& settings) {
  return TireCatalogue().With(ModelsFolder() + "/tires", settings.tire_files);
}

void RequireBodiesAreWheels(const TireNames& names, const std::vector<Wheel>& wheels) {
  std::set<std::string> unknown;
  for (const auto& entry : names.of_body) unknown.insert(entry.first);
  std::vector<std::string> known;
  known.reserve(wheels.size());
  for (const Wheel& wheel : wheels) {
    unknown.erase(wheel.name);
    known.push_back(wheel.name);
  }
  if (unknown.empty()) return;
  throw InputError("softsoil_tire: \"" + *unknown.begin() +
                   "\" is no wheel; wheels are: " + Listed(known));
}

Tire MakeAutoTire(const mjModel* m, const std::vector<Wheel>& wheels, const Wheel& wheel) {
  if (wheel.mesh != nullptr) return RigidTire(m, wheel);
  if (wheel.outline == WheelOutline::kUnknown) {
    throw InputError("softsoil_tire: wheel \"" + wheel.name +
                     "\" has no round geom, so its tire must be named");
  }
  if (wheel.half_width > kWidestPerRadius / 2 * wheel.radius) {
    throw InputError("softsoil_tire: wheel \"" + wheel.name + "\" has the half width " +
                     Shown(wheel.half_width) + " m, more than 5 times its radius " +
                     Shown(wheel.radius) + " m: it is no wheel, or its tire must be named");
  }
  Tire tire = AutoTire(wheel, StaticLoad(m, wheels, wheel));
  Say("no tire is named: a stiff one of the geom's size, radius " + Shown(tire.shape.radius) +
      " m, width " + Shown(tire.shape.width) + " m");
  return tire;
}

// A shape has the lugs that it shows.
void RefuseSecondSurface(const Wheel& wheel, const Tire& tire) {
  if (!tire.shape.lugs && tire.mesh == nullptr) return;
  throw InputError("softsoil_tire: wheel \"" + wheel.name +
                   "\" has a shape of its own in softsoil_shapes; its tire must be one without "
                   "<lugs> and <mesh>, got \"" +
                   tire.name + "\"");
}

}  // namespace

double StaticLoad(const mjModel* m, const std::vector<Wheel>& wheels, const Wheel& wheel) {
  const int root = m->body_rootid[wheel.body];
  const auto count = std::count_if(wheels.begin(), wheels.end(), [&](const Wheel& other) {
    return m->body_rootid[other.body] == root && other.joint >= 0;
  });
  return m->body_subtreemass[root] * -m->opt.gravity[2] / static_cast<double>(count);
}

Tire AutoTire(const Wheel& wheel, double load) {
  Tire tire;
  tire.name = kAutoTire;
  tire.description = "stiff tire of the geom's size";
  tire.shape = ShapeOf(wheel);
  tire.soil_friction = kSoilFriction;
  tire.damping = 0;
  tire.spring.linear = 1;
  const double z = kDeflection * wheel.radius;
  tire.spring.linear = load / FlatPlateLoad(tire, z, wheel.radius / 100);

  const double stiffness = load / z;
  const double area = load / SpringPressure(tire.spring, kMeanPenetration * z);
  tire.damping = 2 * kDampingRatio * std::sqrt(stiffness * load / kGravity) / area;
  return tire;
}

std::vector<Tire> ChooseTires(const mjModel* m, const std::vector<Wheel>& wheels,
                              const Settings& settings) {
  const Catalogue<Tire> catalogue = AllTires(settings);
  RequireBodiesAreWheels(settings.tires, wheels);
  std::vector<Tire> tires;
  for (const Wheel& wheel : wheels) {
    const auto own = settings.tires.of_body.find(wheel.name);
    const std::string& of_rest = wheel.joint < 0 ? kAutoTire : settings.tires.of_all;
    const std::string& name = own == settings.tires.of_body.end() ? of_rest : own->second;
    if (name == kAutoTire) {
      tires.push_back(MakeAutoTire(m, wheels, wheel));
    } else {
      tires.push_back(At("softsoil_tire", [&] { return FindTire(catalogue, name); }));
      WarnOfRadius(wheel, tires.back());
      if (wheel.mesh != nullptr) {
        RefuseSecondSurface(wheel, tires.back());
        tires.back() = WithShape(tires.back(), wheel);
      }
    }
  }
  return tires;
}

}  // namespace softsoil
