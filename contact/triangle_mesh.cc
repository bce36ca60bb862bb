#include "contact/triangle_mesh.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>
#include <unordered_map>

#include "terrain/input_error.h"

namespace softsoil {
namespace {

using Eigen::Vector3d;

constexpr double kMergedWithin = 1e-6;     // of the size
constexpr double kLeastHeight = 1e-9;      // of a triangle, per longest edge: less is rounding
constexpr double kLeastThickness = 1e-12;  // of a part: volume per area^1.5

const Vector3d& Corner(const TriangleMesh& mesh, int triangle, int k) {
  return mesh.vertices[mesh.triangles[triangle][k % 3]];
}

int Count(const TriangleMesh& mesh) { return static_cast<int>(mesh.triangles.size()); }

std::string PointText(const Vector3d& p) {
  return "(" + Rounded(p.x(), 6) + ", " + Rounded(p.y(), 6) + ", " + Rounded(p.z(), 6) + ")";
}

[[noreturn]] void Refuse(int triangle, const std::string& rule) {
  throw InputError("triangle " + std::to_string(triangle + 1) + ": " + rule);
}

using Cell = std::array<long, 3>;
struct HashOfCell {
  std::size_t operator()(const Cell& c) const {
    return (static_cast<std::size_t>(c[0]) * 73856093) ^
           (static_cast<std::size_t>(c[1]) * 19349663) ^
           (static_cast<std::size_t>(c[2]) * 83492791);
  }
};

// Vertices that are kept, by cells of the side `reach` [m]. No two of them are so close along all
// axes, hence no two in one cell.
class Kept {
 public:
  Kept(const Vector3d& origin, double reach) : origin_(origin), reach_(reach) {}

  // The vertex within reach of `v`; if there is none, `v` itself from now on.
  int Place(const Vector3d& v) {
    const Cell own = CellOf(v);
    for (long i = -1; i <= 1; ++i) {
      for (long j = -1; j <= 1; ++j) {
        for (long k = -1; k <= 1; ++k) {
          const auto found = by_cell_.find({own[0] + i, own[1] + j, own[2] + k});
          if (found == by_cell_.end()) continue;
          if ((vertices_[found->second] - v).lpNorm<Eigen::Infinity>() <= reach_)
            return found->second;
        }
      }
    }
    vertices_.push_back(v);
    return by_cell_[own] = static_cast<int>(vertices_.size()) - 1;
  }

  const std::vector<Vector3d>& vertices() const { return vertices_; }

 private:
  Cell CellOf(const Vector3d& v) const {
    const Vector3d cells = (v - origin_) / reach_;
    return {std::lround(cells.x()), std::lround(cells.y()), std::lround(cells.z())};
  }

  Vector3d origin_;
  double reach_;
  std::vector<Vector3d> vertices_;
  std::unordered_map<Cell, int, HashOfCell> by_cell_;
};

// The edge from corner `side` of a triangle to the next.
struct Edge {
  int low, high;  // its vertices
  int triangle, side;
  bool rises;  // from low to high

  bool JoinsTheSame(const Edge& other) const { return low == other.low && high == other.high; }
};

std::vector<Edge> SortedEdges(const TriangleMesh& mesh) {
  std::vector<Edge> edges;
  edges.reserve(3 * mesh.triangles.size());
  for (int t = 0; t < Count(mesh); ++t) {
    for (int k = 0; k < 3; ++k) {
      const int from = mesh.triangles[t][k], to = mesh.triangles[t][(k + 1) % 3];
      edges.push_back({std::min(from, to), std::max(from, to), t, k, from < to});
    }
  }
  std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) {
    return std::tie(a.low, a.high, a.triangle, a.side) <
           std::tie(b.low, b.high, b.triangle, b.side);
  });
  return edges;
}

void RequirePair(const TriangleMesh& mesh, const Edge* edge, std::ptrdiff_t count) {
  const std::string where = "its edge from " + PointText(mesh.vertices[edge->low]) + " to " +
                            PointText(mesh.vertices[edge->high]);
  if (count != 2) {
    const char* name = count == 1 ? "open" : "not a surface";
    Refuse(edge->triangle, where + " must be shared by 2 triangles, got " + std::to_string(count) +
                               ": the mesh is " + name + " there");
  }
  if (edge[0].rises != edge[1].rises) return;
  Refuse(edge->triangle, where + " must run against that of triangle " +
                             std::to_string(edge[1].triangle + 1) +
                             ", got the same direction: one of the two is inside out");
}

void RequireAreas(const TriangleMesh& mesh) {
  for (int t = 0; t < Count(mesh); ++t) {
    double longest = 0;
    for (int k = 0; k < 3; ++k) {
      longest = std::max(longest, (Corner(mesh, t, k + 1) - Corner(mesh, t, k)).norm());
    }
    const double area = AreaVector(mesh, t).norm();
    if (!std::isfinite(area))
      Refuse(t, "its corners must be finite, got an area of " + Shown(area));
    if (2 * area > kLeastHeight * longest * longest) continue;
    Refuse(t, "its area must be > 0 m^2, got " + Rounded(area, 3) + " at " +
                  PointText(Centroid(mesh, t)));
  }
}

// Volume [m^3] of the pyramid from `apex` to a triangle, positive if that faces away.
double Pyramid(const TriangleMesh& mesh, int triangle, const Vector3d& apex) {
  return AreaVector(mesh, triangle).dot(Corner(mesh, triangle, 0) - apex) / 3;
}

struct Part {
  int first = -1, triangles = 0;
  double volume = 0, area = 0;  // [m^3], [m^2]
};

void RequireOutward(const TriangleMesh& mesh, const std::vector<int>& part_of) {
  std::vector<Part> parts(*std::max_element(part_of.begin(), part_of.end()) + 1);
  for (int t = 0; t < Count(mesh); ++t) {
    Part& part = parts[part_of[t]];
    if (part.first < 0) part.first = t;
    ++part.triangles;
    part.volume += Pyramid(mesh, t, Corner(mesh, part.first, 0));
    part.area += AreaVector(mesh, t).norm();
  }
  for (const Part& part : parts) {
    if (part.volume > kLeastThickness * std::pow(part.area, 1.5)) continue;
    Refuse(part.first, "the " + std::to_string(part.triangles) +
                           " triangles connected to it must enclose a volume > 0 m^3, got " +
                           Rounded(part.volume, 3) +
                           ": it is inside out; corners must be counter-clockwise seen from "
                           "outside, and there must be no cavity");
  }
}

}  // namespace

Extent ExtentOf(const TriangleMesh& mesh) {
  Extent extent{mesh.vertices.front(), mesh.vertices.front()};
  for (const Vector3d& v : mesh.vertices) {
    extent.low = extent.low.cwiseMin(v);
    extent.high = extent.high.cwiseMax(v);
  }
  return extent;
}

double RadiusAboutY(const TriangleMesh& mesh) {
  double radius = 0;
  for (const Vector3d& v : mesh.vertices) radius = std::max(radius, std::hypot(v.x(), v.z()));
  return radius;
}

Vector3d AreaVector(const TriangleMesh& mesh, int triangle) {
  const Vector3d& a = Corner(mesh, triangle, 0);
  return (Corner(mesh, triangle, 1) - a).cross(Corner(mesh, triangle, 2) - a) / 2;
}

Vector3d Centroid(const TriangleMesh& mesh, int triangle) {
  return (Corner(mesh, triangle, 0) + Corner(mesh, triangle, 1) + Corner(mesh, triangle, 2)) / 3;
}

double Area(const TriangleMesh& mesh) {
  double area = 0;
  for (int t = 0; t < Count(mesh); ++t) area += AreaVector(mesh, t).norm();
  return area;
}

double Volume(const TriangleMesh& mesh) {
  double volume = 0;
  for (int t = 0; t < Count(mesh); ++t) volume += Pyramid(mesh, t, Corner(mesh, 0, 0));
  return volume;
}

TriangleMesh WithVerticesMerged(const TriangleMesh& mesh) {
  if (mesh.vertices.empty()) return mesh;
  const Extent box = ExtentOf(mesh);
  const double size = box.Size().maxCoeff();
  if (!(size > 0) || !std::isfinite(size)) return mesh;
  Kept kept(box.low, kMergedWithin * size);
  std::vector<int> place;
  place.reserve(mesh.vertices.size());
  for (const Vector3d& v : mesh.vertices) place.push_back(kept.Place(v));
  TriangleMesh merged{kept.vertices(), mesh.triangles};
  for (std::array<int, 3>& corners : merged.triangles) {
    for (int& corner : corners) corner = place[corner];
  }
  return merged;
}

std::vector<std::array<int, 3>> Neighbours(const TriangleMesh& mesh) {
  const std::vector<Edge> edges = SortedEdges(mesh);
  std::vector<std::array<int, 3>> neighbours(mesh.triangles.size());
  for (auto edge = edges.begin(); edge != edges.end(); edge += 2) {
    const auto end = std::find_if_not(edge, edges.end(),
                                      [&](const Edge& other) { return edge->JoinsTheSame(other); });
    RequirePair(mesh, &*edge, end - edge);
    neighbours[edge[0].triangle][edge[0].side] = edge[1].triangle;
    neighbours[edge[1].triangle][edge[1].side] = edge[0].triangle;
  }
  return neighbours;
}

std::vector<int> Parts(const std::vector<std::array<int, 3>>& neighbours) {
  std::vector<int> part_of(neighbours.size(), -1), open;
  int parts = 0;
  for (std::size_t start = 0; start < neighbours.size(); ++start) {
    if (part_of[start] >= 0) continue;
    part_of[start] = parts;
    open.push_back(static_cast<int>(start));
    while (!open.empty()) {
      const int t = open.back();
      open.pop_back();
      for (const int next : neighbours[t]) {
        if (part_of[next] >= 0) continue;
        part_of[next] = parts;
        open.push_back(next);
      }
    }
    ++parts;
  }
  return part_of;
}

void RequireClosed(const TriangleMesh& mesh) {
  if (mesh.triangles.empty()) throw InputError("there must be triangles, got none");
  const double size = ExtentOf(mesh).Size().maxCoeff();
  if (size > kLargestMesh) {
    throw InputError("the mesh must be at most " + Shown(kLargestMesh) + " m long, got " +
                     Rounded(size, 3) + " m; is it in millimetres?");
  }
  RequireAreas(mesh);
  RequireOutward(mesh, Parts(Neighbours(mesh)));
}

}  // namespace softsoil
