#include "plugin/wheel_finder.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "plugin/model_geometry.h"
#include "terrain/constants.h"
#include "terrain/input_error.h"

namespace softsoil {
namespace {

using Eigen::Vector3d;

const double kLeastCosine = std::cos(2 * kPi / 180);  // between hinge and geom axis
constexpr double kFarthestOff = 0.05;                 // of the radius, hinge beside geom centre

// A body that turns about an unlimited hinge.
struct Spin {
  int joint;
  Vector3d anchor_b, axis_b;  // frame of the wheel body
};

// A round geom on a spin axis.
struct Candidate {
  Wheel wheel;
  bool collides;
  double position;     // [m]  of the centre along the hinge
  double half_extent;  // [m]  along the hinge
};

struct Round {
  WheelOutline outline;
  double radius, half_width;  // [m]
  std::optional<int> axis;    // column of the geom's frame; none for a sphere
};

// The axis about which an ellipsoid is round.
std::optional<int> AxisOfRevolution(const mjtNum size[3]) {
  for (int k : {2, 1, 0}) {
    const double a = size[(k + 1) % 3], b = size[(k + 2) % 3];
    if (std::abs(a - b) <= 0.01 * std::max(a, b)) return k;
  }
  return std::nullopt;
}

std::optional<Round> RoundGeom(const mjModel* m, int geom) {
  const mjtNum* size = m->geom_size + 3 * geom;
  switch (m->geom_type[geom]) {
    case mjGEOM_CYLINDER: return Round{WheelOutline::kCylinder, size[0], size[1], 2};
    case mjGEOM_CAPSULE: return Round{WheelOutline::kCapsule, size[0], size[1], 2};
    case mjGEOM_SPHERE: return Round{WheelOutline::kSphere, size[0], size[0], std::nullopt};
    case mjGEOM_ELLIPSOID: {
      const std::optional<int> axis = AxisOfRevolution(size);
      if (!axis) return std::nullopt;
      return Round{WheelOutline::kEllipsoid, size[(*axis + 1) % 3], size[*axis], axis};
    }
    default: return std::nullopt;
  }
}

// Direction [-] to the left of the vehicle or, where the axis runs along the vehicle, rearward:
// forward = axis x up agrees with the x axis of the root body, or its y axis if perpendicular.
Vector3d TowardsLeft(const Vector3d& axis_w, const mjModel* m, int body) {
  const Vector3d forward_w = axis_w.cross(Vector3d::UnitZ());
  const Eigen::Matrix3d root = PoseAtStart(m, m->body_rootid[body], 0).orientation;
  const double along_x = forward_w.dot(root.col(0));
  const double agreement = std::abs(along_x) > 0.1 ? along_x : forward_w.dot(root.col(1));
  return agreement < 0 ? Vector3d(-axis_w) : axis_w;
}

// Hinges of the body, or of the body it is welded to, that may be spin axes; last one first, as
// it turns innermost. The axis points to the left.
std::vector<Spin> SpinsOf(const mjModel* m, int body) {
  const int turning = m->body_weldid[body];
  const Frame wheel = PoseAtStart(m, body, turning);
  const Eigen::Matrix3d to_world = PoseAtStart(m, body, 0).orientation;
  std::vector<Spin> spins;
  for (int k = m->body_jntnum[turning] - 1; k >= 0; --k) {
    const int joint = m->body_jntadr[turning] + k;
    if (m->jnt_type[joint] != mjJNT_HINGE || m->jnt_limited[joint]) continue;
    const Eigen::Matrix3d to_wheel = wheel.orientation.transpose();
    const Vector3d axis_b = (to_wheel * Vector(m->jnt_axis + 3 * joint)).normalized();
    const Vector3d axis_w = to_world * axis_b;
    if (std::abs(axis_w.z()) > std::sqrt(0.5)) continue;  // a swivel
    const Vector3d anchor_b = to_wheel * (Vector(m->jnt_pos + 3 * joint) - wheel.position);
    spins.push_back({joint, anchor_b, to_world.transpose() * TowardsLeft(axis_w, m, body)});
  }
  return spins;
}

Vector3d OnAxis(const Spin& spin, const Vector3d& point_b) {
  return spin.anchor_b + (point_b - spin.anchor_b).dot(spin.axis_b) * spin.axis_b;
}

std::optional<Candidate> Match(const mjModel* m, int geom, const Spin& spin) {
  const std::optional<Round> round = RoundGeom(m, geom);
  if (!round) return std::nullopt;
  const int body = m->geom_bodyid[geom];
  const Frame frame = FrameAt(m->geom_pos + 3 * geom, m->geom_quat + 4 * geom);
  if (round->axis) {
    const double cosine = std::abs(frame.orientation.col(*round->axis).dot(spin.axis_b));
    if (cosine < kLeastCosine) return std::nullopt;
  }
  const Vector3d centre_b = OnAxis(spin, frame.position);
  if ((centre_b - frame.position).norm() > kFarthestOff * round->radius) return std::nullopt;

  Candidate found;
  found.wheel = {body,           WheelName(m, body), spin.joint,        centre_b, spin.axis_b,
                 round->outline, round->radius,      round->half_width, geom};
  found.collides = m->geom_contype[geom] != 0 || m->geom_conaffinity[geom] != 0;
  found.position = (centre_b - spin.anchor_b).dot(spin.axis_b);
  found.half_extent = round->half_width;
  if (round->outline == WheelOutline::kCapsule) found.half_extent += round->radius;
  return found;
}

// Candidates on the innermost hinge of each geom, the best first.
std::vector<Candidate> CandidatesOf(const mjModel* m, int body) {
  std::vector<Candidate> candidates;
  const std::vector<Spin> spins = SpinsOf(m, body);
  for (int k = 0; k < m->body_geomnum[body]; ++k) {
    for (const Spin& spin : spins) {
      const std::optional<Candidate> found = Match(m, m->body_geomadr[body] + k, spin);
      if (!found) continue;
      candidates.push_back(*found);
      break;
    }
  }
  return candidates;
}

void BestFirst(std::vector<Candidate>* candidates) {
  std::stable_sort(candidates->begin(), candidates->end(),
                   [](const Candidate& a, const Candidate& b) {
                     if (a.collides != b.collides) return a.collides;
                     return a.wheel.radius > b.wheel.radius;
                   });
}

bool Overlap(const Candidate& a, const Candidate& b) {
  return std::abs(a.position - b.position) < a.half_extent + b.half_extent;
}

// The wheels that turn with one hinge.
std::vector<Wheel> ChooseWheels(std::vector<Candidate> candidates) {
  BestFirst(&candidates);
  std::vector<Candidate> chosen;
  for (const Candidate& candidate : candidates) {
    const bool is_doubled =
        std::any_of(chosen.begin(), chosen.end(), [&candidate](const Candidate& other) {
          return candidate.wheel.body == other.wheel.body || Overlap(candidate, other);
        });
    if (!is_doubled) chosen.push_back(candidate);
  }
  std::vector<Wheel> wheels;
  wheels.reserve(chosen.size());
  for (const Candidate& candidate : chosen) wheels.push_back(candidate.wheel);
  return wheels;
}

std::vector<Wheel> FindAll(const mjModel* m) {
  std::map<int, std::vector<Candidate>> by_joint;
  for (int body = 1; body < m->nbody; ++body) {
    for (const Candidate& found : CandidatesOf(m, body)) {
      by_joint[found.wheel.joint].push_back(found);
    }
  }
  std::vector<Wheel> wheels;
  for (const auto& [joint, candidates] : by_joint) {
    for (const Wheel& wheel : ChooseWheels(candidates)) wheels.push_back(wheel);
  }
  std::sort(wheels.begin(), wheels.end(),
            [](const Wheel& a, const Wheel& b) { return a.body < b.body; });
  return wheels;
}

bool HasMesh(const mjModel* m, int body) {
  for (int k = 0; k < m->body_geomnum[body]; ++k) {
    if (m->geom_type[m->body_geomadr[body] + k] == mjGEOM_MESH) return true;
  }
  return false;
}

[[noreturn]] void Refuse(const std::string& rule) { throw InputError("softsoil_wheels: " + rule); }

// A named body is a wheel if it can turn: its outline may be unknown, as that of a mesh.
Wheel NamedWheel(const mjModel* m, int body) {
  std::vector<Candidate> candidates = CandidatesOf(m, body);
  BestFirst(&candidates);
  if (!candidates.empty()) return candidates.front().wheel;
  const std::vector<Spin> spins = SpinsOf(m, body);
  if (spins.empty()) {
    Refuse(BodyName(m, body) +
           " has no spin axis: it must turn about an unlimited hinge of its own or of "
           "the body it is welded to, and nearer to level than to upright");
  }
  if (!HasMesh(m, body)) {
    Refuse(BodyName(m, body) +
           " has no geom round about its hinge: it must have a cylinder, capsule, "
           "ellipsoid or sphere whose axis is within 2 degrees of the hinge and whose "
           "centre is within 5 % of the radius of it, or a mesh");
  }
  return TurningBody(m, body);
}

int BodyWithName(const mjModel* m, const std::string& name) {
  for (int body = 1; body < m->nbody; ++body) {
    if (WheelName(m, body) == name) return body;
  }
  Refuse("the model has no body \"" + name + "\"");
}

}  // namespace

Wheel TurningBody(const mjModel* m, int body) {
  Wheel wheel = {body,
                 WheelName(m, body),
                 -1,
                 Vector(m->body_ipos + 3 * body),
                 Vector3d::UnitY(),
                 WheelOutline::kUnknown,
                 0,
                 0,
                 -1};
  const std::vector<Spin> spins = SpinsOf(m, body);
  if (spins.empty()) return wheel;
  wheel.joint = spins.front().joint;
  wheel.centre_b = OnAxis(spins.front(), wheel.centre_b);
  wheel.axis_b = spins.front().axis_b;
  return wheel;
}

std::vector<Wheel> FindWheels(const mjModel* m, const std::vector<std::string>& named,
                              bool needed) {
  std::vector<Wheel> wheels;
  std::set<int> bodies;
  for (const std::string& name : named) {
    const int body = BodyWithName(m, name);
    if (!bodies.insert(body).second) Refuse(BodyName(m, body) + " is named twice");
    wheels.push_back(NamedWheel(m, body));
  }
  if (named.empty()) wheels = FindAll(m);
  if (wheels.empty() && needed) {
    throw InputError(
        "no wheels found: the model must have a body with a cylinder, capsule, ellipsoid or "
        "sphere on an unlimited hinge along its axis, or name its wheels in a <custom> <tuple "
        "name=\"softsoil_wheels\">");
  }
  return wheels;
}

}  // namespace softsoil
