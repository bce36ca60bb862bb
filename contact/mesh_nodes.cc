#include "contact/mesh_nodes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "terrain/constants.h"
#include "terrain/input_error.h"

namespace softsoil {
namespace {

using Eigen::Vector3d;

struct Triangle {
  std::array<Vector3d, 3> corners;

  Vector3d AreaVector() const {
    return (corners[1] - corners[0]).cross(corners[2] - corners[0]) / 2;
  }
  Vector3d Centroid() const { return (corners[0] + corners[1] + corners[2]) / 3; }
  double Edge(int k) const { return (corners[(k + 1) % 3] - corners[k]).norm(); }
  int LongestEdge() const {
    int longest = 0;
    for (int k : {1, 2}) {
      if (Edge(k) > Edge(longest)) longest = k;
    }
    return longest;
  }
};

// Unit vector along v [m], any across the y axis where v has no length to speak of.
Vector3d Along(const Vector3d& v) { return v.norm() > 1e-9 ? v.normalized() : Vector3d::UnitX(); }

void AddNode(const Vector3d& position, const Vector3d& normal, double area, TireNodes* nodes) {
  const Vector3d in_plane(position.x(), 0, position.z());
  const Vector3d across = normal.cross(Vector3d::UnitY());  // as along the circumference
  nodes->position_t.push_back(position);
  nodes->radial_t.push_back(Along(in_plane));
  nodes->normal_t.push_back(normal);
  nodes->tangent_t.push_back(Along(across));
  nodes->binormal_t.push_back(normal.cross(nodes->tangent_t.back()));
  nodes->radius.push_back(in_plane.norm());
  nodes->area.push_back(area);
}

using TriangleNeighbours = std::vector<std::array<int, 3>>;

// By triangle the face that it is of: no edge within a face turns by more than kSmoothTurn.
std::vector<int> Faces(const TriangleMesh& mesh, TriangleNeighbours neighbours) {
  for (std::size_t t = 0; t < neighbours.size(); ++t) {
    const Vector3d normal = AreaVector(mesh, static_cast<int>(t)).normalized();
    for (int& next : neighbours[t]) {
      const bool turns = AreaVector(mesh, next).normalized().dot(normal) < std::cos(kSmoothTurn);
      if (turns) next = static_cast<int>(t);
    }
  }
  return Parts(neighbours);
}

// Solid angle [rad] that a triangle covers, seen from a point; positive from behind it. Van
// Oosterom and Strackee (1983).
double SolidAngle(const TriangleMesh& mesh, int triangle, const Vector3d& from) {
  const std::array<int, 3>& corners = mesh.triangles[triangle];
  const Vector3d a = mesh.vertices[corners[0]] - from, b = mesh.vertices[corners[1]] - from,
                 c = mesh.vertices[corners[2]] - from;
  const double la = a.norm(), lb = b.norm(), lc = c.norm();
  return 2 * std::atan2(a.dot(b.cross(c)),
                        la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
}

// The parts of a closed mesh that hang together.
class Solids {
 public:
  Solids(const TriangleMesh& mesh, const TriangleNeighbours& neighbours) : mesh_(mesh) {
    const std::vector<int> part_of = Parts(neighbours);
    for (std::size_t t = 0; t < part_of.size(); ++t) {
      if (part_of[t] == static_cast<int>(solids_.size())) solids_.push_back({});
      Solid& solid = solids_[part_of[t]];
      solid.triangles.push_back(static_cast<int>(t));
      for (const int corner : mesh.triangles[t]) solid.box.extend(mesh.vertices[corner]);
    }
  }

  // Whether a point is within one of several, where the soil does not get.
  bool Cover(const Vector3d& point) const {
    if (solids_.size() < 2) return false;
    return std::any_of(solids_.begin(), solids_.end(), [&](const Solid& solid) {
      if (!solid.box.contains(point)) return false;
      double angle = 0;
      for (const int t : solid.triangles) angle += SolidAngle(mesh_, t, point);
      return angle > 2 * kPi;
    });
  }

 private:
  struct Solid {
    Eigen::AlignedBox3d box;
    std::vector<int> triangles;
  };
  const TriangleMesh& mesh_;
  std::vector<Solid> solids_;
};

// Puts the pieces of triangles into nodes: those of a face in a cube of the spacing.
class Gatherer {
 public:
  explicit Gatherer(double spacing) : spacing_(spacing) {}

  void Add(const Triangle& whole, int face) {
    std::vector<Triangle> parts = {whole};
    while (!parts.empty()) {
      const Triangle part = parts.back();
      parts.pop_back();
      const int k = part.LongestEdge();
      if (part.Edge(k) <= kLongestEdge * spacing_) {
        AddPiece(part, face);
        continue;
      }
      const Vector3d &from = part.corners[k], &to = part.corners[(k + 1) % 3],
                     &apex = part.corners[(k + 2) % 3];
      const Vector3d middle = (from + to) / 2;
      parts.push_back({{middle, to, apex}});
      parts.push_back({{from, middle, apex}});
    }
  }

  // The nodes whose place is one to be asked for: is_there(a point on the surface, its normal).
  template <class IsThere>
  TireNodes Nodes(const IsThere& is_there) const {
    TireNodes nodes;
    for (const Gathered& g : gathered_) {
      if (!is_there(g.point, g.normal)) continue;
      AddNode(g.moment / g.area, g.area_vector.normalized(), g.area, &nodes);
    }
    return nodes;
  }

 private:
  static constexpr double kLongestEdge = 0.5;  // [-]  of a piece, of the spacing
  static constexpr double kRounding = 1e-6;    // [-]  a face between two cubes is in the upper one

  struct Gathered {
    Vector3d point;        // [m]  in its first piece
    Vector3d normal;       // there
    Vector3d area_vector;  // [m^2]
    Vector3d moment;       // [m^3]
    double area;           // [m^2]
  };
  using Cube = std::array<int, 4>;  // face, and number along each axis

  void AddPiece(const Triangle& piece, int face) {
    const Vector3d centroid = piece.Centroid(), area_vector = piece.AreaVector();
    const double area = area_vector.norm();
    Cube cube = {face, 0, 0, 0};
    for (int axis = 0; axis < 3; ++axis) {
      cube[axis + 1] = static_cast<int>(std::floor(centroid[axis] / spacing_ + kRounding));
    }
    Gathered& node = NodeIn(cube, centroid, area_vector / area);
    node.area_vector += area_vector;
    node.moment += area * centroid;
    node.area += area;
  }

  Gathered& NodeIn(const Cube& cube, const Vector3d& point, const Vector3d& normal) {
    for (const int i : in_cube_[cube]) {
      if (gathered_[i].normal.dot(normal) >= std::cos(kSmoothTurn)) return gathered_[i];
    }
    in_cube_[cube].push_back(static_cast<int>(gathered_.size()));
    gathered_.push_back({point, normal, Vector3d::Zero(), Vector3d::Zero(), 0});
    return gathered_.back();
  }

  double spacing_;
  std::vector<Gathered> gathered_;
  std::map<Cube, std::vector<int>> in_cube_;
};

}  // namespace

TireNodes MakeMeshNodes(const TriangleMesh& mesh, double spacing) {
  if (Area(mesh) > kMostNodes * spacing * spacing) {
    throw InputError("the mesh must have at most " + std::to_string(kMostNodes) +
                     " nodes, got more: the grid spacing is too fine for its area");
  }
  const TriangleNeighbours neighbours = Neighbours(mesh);
  const std::vector<int> faces = Faces(mesh, neighbours);
  Gatherer gatherer(spacing);
  for (std::size_t t = 0; t < faces.size(); ++t) {
    const std::array<int, 3>& v = mesh.triangles[t];
    gatherer.Add({{mesh.vertices[v[0]], mesh.vertices[v[1]], mesh.vertices[v[2]]}}, faces[t]);
  }
  // The wall of a hollow wheel, a spoke in its rim: what lies within another part meets no soil.
  const Solids solids(mesh, neighbours);
  const double just_outside = 1e-6 * ExtentOf(mesh).Size().maxCoeff();
  return gatherer.Nodes([&](const Vector3d& point, const Vector3d& normal) {
    return !solids.Cover(point + just_outside * normal);
  });
}

}  // namespace softsoil
