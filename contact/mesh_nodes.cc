#include "contact/mesh_nodes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <string>

#include "terrain/input_error.h"

namespace softsoil {
namespace {

using Eigen::Vector3d;

// [-]  of the spacing, from the first triangle of a node: as the corner of a square from its
// middle.
constexpr double kReach = 0.7;

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

Triangle TriangleOf(const TriangleMesh& mesh, int t) {
  const std::array<int, 3>& v = mesh.triangles[t];
  return {{mesh.vertices[v[0]], mesh.vertices[v[1]], mesh.vertices[v[2]]}};
}

// Neither longer than two spacings nor larger than a square of one.
bool IsSmall(const Triangle& triangle, double spacing) {
  return triangle.Edge(triangle.LongestEdge()) <= 2 * spacing &&
         triangle.AreaVector().norm() <= spacing * spacing;
}

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
  if (nodes->size() <= kMostNodes) return;
  throw InputError("the mesh must have at most " + std::to_string(kMostNodes) +
                   " nodes, got more: the grid spacing is too fine for its area");
}

void AddParts(const Triangle& triangle, double spacing, TireNodes* nodes) {
  std::vector<Triangle> parts = {triangle};
  while (!parts.empty()) {
    const Triangle part = parts.back();
    parts.pop_back();
    if (IsSmall(part, spacing)) {
      const Vector3d area = part.AreaVector();
      AddNode(part.Centroid(), area.normalized(), area.norm(), nodes);
      continue;
    }
    const int k = part.LongestEdge();
    const Vector3d &from = part.corners[k], &to = part.corners[(k + 1) % 3],
                   &apex = part.corners[(k + 2) % 3];
    const Vector3d middle = (from + to) / 2;
    parts.push_back({{middle, to, apex}});
    parts.push_back({{from, middle, apex}});
  }
}

// Gathers small triangles into nodes.
class Gatherer {
 public:
  Gatherer(const TriangleMesh& mesh, double spacing, std::vector<bool> is_taken)
      : mesh_(mesh), spacing_(spacing), neighbours_(Neighbours(mesh)), is_taken_(is_taken) {}

  // The node that grows from a triangle, if it is not in another one.
  void Grow(int first, TireNodes* nodes) {
    if (is_taken_[first]) return;
    const Triangle seed = TriangleOf(mesh_, first);
    const Vector3d normal = seed.AreaVector().normalized(), centre = seed.Centroid();
    Vector3d area_vector = Vector3d::Zero(), moment = Vector3d::Zero();
    double area = 0;
    std::vector<int> in_node = {first};
    is_taken_[first] = true;
    for (std::size_t i = 0; i < in_node.size(); ++i) {
      const Triangle triangle = TriangleOf(mesh_, in_node[i]);
      const double own = triangle.AreaVector().norm();
      area_vector += triangle.AreaVector();
      moment += own * triangle.Centroid();
      area += own;
      for (const int next : neighbours_[in_node[i]]) {
        if (is_taken_[next] || !Belongs(TriangleOf(mesh_, next), normal, centre)) continue;
        is_taken_[next] = true;
        in_node.push_back(next);
      }
    }
    AddNode(moment / area, area_vector.normalized(), area, nodes);
  }

 private:
  bool Belongs(const Triangle& triangle, const Vector3d& normal, const Vector3d& centre) const {
    return triangle.AreaVector().normalized().dot(normal) >= std::cos(kSmoothTurn) &&
           (triangle.Centroid() - centre).norm() <= kReach * spacing_;
  }

  const TriangleMesh& mesh_;
  double spacing_;
  std::vector<std::array<int, 3>> neighbours_;
  std::vector<bool> is_taken_;
};

}  // namespace

TireNodes MakeMeshNodes(const TriangleMesh& mesh, double spacing) {
  TireNodes nodes;
  const int count = static_cast<int>(mesh.triangles.size());
  std::vector<bool> is_large(count);
  for (int t = 0; t < count; ++t) is_large[t] = !IsSmall(TriangleOf(mesh, t), spacing);
  Gatherer gatherer(mesh, spacing, is_large);
  for (int t = 0; t < count; ++t) {
    if (is_large[t]) {
      AddParts(TriangleOf(mesh, t), spacing, &nodes);
    } else {
      gatherer.Grow(t, &nodes);
    }
  }
  return nodes;
}

}  // namespace softsoil
