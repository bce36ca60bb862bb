#include "plugin/time_step.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/flat_plate.h"
#include "contact/wheel_contact.h"
#include "terrain/shear.h"

namespace softsoil {
namespace {

// A tire on a rigid plate: softer ground only makes the true bound longer.
struct StaticContact {
  double stiffness;  // [N/m]
  double area;       // [m^2]
  double pressure;   // [Pa]  mean
};

StaticContact OnRigidPlate(const Tire& tire, double load) {
  const double radius = tire.shape.radius;
  const double node_spacing = radius / 50;
  double low = 0, high = radius / 2;
  for (int i = 0; i < 30; ++i) {  // halving: the load grows with the deflection
    const double z = (low + high) / 2;
    (FlatPlateLoad(tire, z, node_spacing) < load ? low : high) = z;
  }
  const double z = std::max(high, radius / 1000);
  const double near = FlatPlateLoad(tire, 0.8 * z, node_spacing);
  const double far = FlatPlateLoad(tire, 1.2 * z, node_spacing);
  const double pressure = SpringPressure(tire.spring, z * 2 / 3);  // of a round patch
  return {(far - near) / (0.4 * z), load / pressure, pressure};
}

}  // namespace

double LongestStep(const Oscillator& o) {
  if (!std::isfinite(o.mass)) return std::numeric_limits<double>::infinity();  // held fast
  return 4 * o.mass / (o.damping + std::sqrt(o.damping * o.damping + 4 * o.stiffness * o.mass));
}

double LongestStep(const mjModel* m, const Wheel& wheel, const Tire& tire, const Soil& soil,
                   double load) {
  const StaticContact contact = OnRigidPlate(tire, load);
  const double inverse_mass = m->body_invweight0[2 * wheel.body];  // [1/kg]
  const double radius = tire.shape.radius;
  const double inverse_rolling_mass =
      inverse_mass + radius * radius * m->dof_invweight0[m->jnt_dofadr[wheel.joint]];
  const double shear_stiffness = ShearStrength(soil.shear, tire.soil_friction, contact.pressure) /
                                 soil.shear.modulus * contact.area;
  return std::min(
      LongestStep({1 / inverse_mass, contact.stiffness, tire.damping * contact.area}),
      LongestStep({1 / inverse_rolling_mass, shear_stiffness, kShearLead * shear_stiffness}));
}

}  // namespace softsoil
