#include "plugin/rigid_contact.h"

#include <algorithm>

#include "plugin/model_geometry.h"
#include "terrain/input_error.h"

namespace softsoil {
namespace {

// Bodies that do not move against each other, and a body and its parent, do not collide.
bool FilteredByBodies(const mjModel* m, int geom1, int geom2) {
  const int weld1 = m->body_weldid[m->geom_bodyid[geom1]];
  const int weld2 = m->body_weldid[m->geom_bodyid[geom2]];
  if (weld1 == weld2) return true;
  if ((m->opt.disableflags & mjDSBL_FILTERPARENT) != 0 || weld1 == 0 || weld2 == 0) return false;
  const int parent1 = m->body_weldid[m->body_parentid[weld1]];
  const int parent2 = m->body_weldid[m->body_parentid[weld2]];
  return weld1 == parent2 || weld2 == parent1;
}

bool IsExcluded(const mjModel* m, int body1, int body2) {
  const int signature = ((std::min(body1, body2) + 1) << 16) + std::max(body1, body2) + 1;
  const int *begin = m->exclude_signature, *end = begin + m->nexclude;
  return std::find(begin, end, signature) != end;
}

bool IsPaired(const mjModel* m, int geom1, int geom2) {
  for (int i = 0; i < m->npair; ++i) {
    const int a = m->pair_geom1[i], b = m->pair_geom2[i];
    if ((a == geom1 && b == geom2) || (a == geom2 && b == geom1)) return true;
  }
  return false;
}

// The lowest bit that no geom uses, or 0.
int FreeBit(const mjModel* m) {
  unsigned used = 0;
  for (int geom = 0; geom < m->ngeom; ++geom) {
    used |= m->geom_contype[geom] | m->geom_conaffinity[geom];
  }
  for (int bit = 0; bit < 31; ++bit) {
    if ((used & (1u << bit)) == 0) return 1 << bit;
  }
  return 0;
}

std::string InQuotes(int number) { return "\"" + std::to_string(number) + "\""; }

// The conaffinity that geoms need to go on touching the ground. Those that are alike are told in
// one sentence.
std::string ConaffinityOfOthers(const mjModel* m, int ground, int bit,
                                const std::vector<bool>& is_wheels) {
  std::vector<int> values;
  for (int geom = 0; geom < m->ngeom; ++geom) {
    if (geom == ground || is_wheels[geom] || !MayCollide(m, ground, geom)) continue;
    const int value = m->geom_conaffinity[geom];
    if (std::find(values.begin(), values.end(), value) == values.end()) values.push_back(value);
  }
  std::vector<std::string> parts;
  parts.reserve(values.size());
  for (const int value : values) {
    parts.push_back("conaffinity=" + InQuotes(value | bit) + " where it is " + InQuotes(value));
  }
  if (parts.empty()) return "";
  return ", and to every geom but those of the wheels " + Listed(parts);
}

std::string Remedy(const mjModel* m, int ground, const std::vector<bool>& is_wheels) {
  std::string by_filter =
      "Write <text name=\"softsoil_rigid_contact\" data=\"remove\"/> into <custom>";
  const int bit = FreeBit(m);
  if (bit == 0) return by_filter;
  return by_filter + "; or give " + GeomName(m, ground) + " contype=" + InQuotes(bit) +
         " conaffinity=\"0\"" + ConaffinityOfOthers(m, ground, bit, is_wheels);
}

}  // namespace

bool MayCollide(const mjModel* m, int geom1, int geom2) {
  const bool bits_match = (m->geom_contype[geom1] & m->geom_conaffinity[geom2]) != 0 ||
                          (m->geom_contype[geom2] & m->geom_conaffinity[geom1]) != 0;
  return bits_match && !FilteredByBodies(m, geom1, geom2);
}

std::vector<bool> GeomsOfWheels(const mjModel* m, const std::vector<Wheel>& wheels) {
  std::vector<bool> is_wheels(m->ngeom, false);
  for (int geom = 0; geom < m->ngeom; ++geom) {
    const int turning = m->body_weldid[m->geom_bodyid[geom]];
    is_wheels[geom] = std::any_of(wheels.begin(), wheels.end(), [&](const Wheel& wheel) {
      return m->body_weldid[wheel.body] == turning;
    });
  }
  return is_wheels;
}

std::string RigidContactWarning(const mjModel* m, int ground, const std::vector<Wheel>& wheels,
                                bool filtered) {
  const std::vector<bool> is_wheels = GeomsOfWheels(m, wheels);
  std::vector<std::string> touching, paired;
  for (int geom = 0; geom < m->ngeom; ++geom) {
    if (!is_wheels[geom]) continue;
    const bool excluded = IsExcluded(m, m->geom_bodyid[geom], m->geom_bodyid[ground]);
    if (MayCollide(m, ground, geom) && !excluded) touching.push_back(GeomName(m, geom));
    if (IsPaired(m, ground, geom)) paired.push_back(GeomName(m, geom));
  }
  const std::string problem =
      "the rigid " + GeomName(m, ground) + " carries wheels instead of the soil: ";
  if (!paired.empty()) return problem + "delete the <contact> <pair> with " + Listed(paired);
  if (touching.empty() || filtered) return "";
  return problem + Listed(touching) + ". " + Remedy(m, ground, is_wheels);
}

}  // namespace softsoil
