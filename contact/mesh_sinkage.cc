#include "contact/mesh_sinkage.h"

#include <algorithm>
#include <cmath>

#include "contact/plastic_sinkage.h"

namespace softsoil {
namespace {

using Eigen::Vector3d;

// Twice the area that the edge between two vertices spans with the point x, y; positive on its
// left. The vertices are taken in the order of their numbers, so that both triangles at the edge
// get the same value but for its sign.
double LeftOf(const std::vector<Vector3d>& vertices, int from, int to, double x, double y) {
  const bool rises = from < to;
  const Vector3d &a = vertices[rises ? from : to], &b = vertices[rises ? to : from];
  const double cross = (b.x() - a.x()) * (y - a.y()) - (b.y() - a.y()) * (x - a.x());
  return rises ? cross : -cross;
}

// The whole numbers in a range, cut off at 0 and `count` - 1.
struct NodeRange {
  int first, last;
};
NodeRange Inside(double low, double high, int count) {
  const double first = std::max(0.0, std::ceil(low)),
               last = std::min(count - 1.0, std::floor(high));
  if (!(first <= last)) return {0, -1};
  return {static_cast<int>(first), static_cast<int>(last)};
}

}  // namespace

Shadow ShadowOf(const TriangleMesh& mesh, const MeshPose& pose) {
  Shadow shadow{kNothingAbove, -kNothingAbove, kNothingAbove, -kNothingAbove};
  for (const Vector3d& vertex : mesh.vertices) {
    const double x = pose.origin_w.x() + pose.frame_w.row(0).dot(vertex);
    const double y = pose.origin_w.y() + pose.frame_w.row(1).dot(vertex);
    shadow.x_min = std::min(shadow.x_min, x);
    shadow.x_max = std::max(shadow.x_max, x);
    shadow.y_min = std::min(shadow.y_min, y);
    shadow.y_max = std::max(shadow.y_max, y);
  }
  return shadow;
}

void Underside::Draw(const TriangleMesh& mesh, const MeshPose& pose, const SurfacePatch& patch) {
  nodes_x_ = patch.nodes_x();
  nodes_y_ = patch.nodes_y();
  lowest_.assign(static_cast<std::size_t>(nodes_x_) * nodes_y_, kNothingAbove);
  vertices_g_.clear();
  for (const Vector3d& vertex : mesh.vertices) {
    const Vector3d v = pose.origin_w + pose.frame_w * vertex;
    vertices_g_.emplace_back(v.x() / patch.spacing() - patch.first().i,
                             v.y() / patch.spacing() - patch.first().j, v.z());
  }
  for (const std::array<int, 3>& corners : mesh.triangles) {
    const auto z = [&](int k) { return vertices_g_[corners[k]].z(); };
    if (std::min({z(0), z(1), z(2)}) <= patch.highest()) DrawTriangle(corners);
  }
}

void Underside::Open() {
  const auto at = [this](int a, int b) -> double& { return lowest_[a * nodes_y_ + b]; };
  // Each of the two steps along x, then along y; in place, so from the side that is not needed.
  for (const GridNode next : {GridNode{1, 0}, GridNode{0, 1}}) {
    for (int a = 0; a < nodes_x_; ++a) {
      for (int b = 0; b < nodes_y_; ++b) {
        const bool is_last = a + next.i == nodes_x_ || b + next.j == nodes_y_;
        at(a, b) = is_last ? kNothingAbove : std::max(at(a, b), at(a + next.i, b + next.j));
      }
    }
  }
  for (const GridNode next : {GridNode{1, 0}, GridNode{0, 1}}) {
    for (int a = nodes_x_ - 1; a >= next.i; --a) {
      for (int b = nodes_y_ - 1; b >= next.j; --b) {
        at(a, b) = std::min(at(a, b), at(a - next.i, b - next.j));
      }
    }
  }
}

void Underside::DrawTriangle(const std::array<int, 3>& corners) {
  const auto [i, j, k] = corners;
  const Vector3d &p = vertices_g_[i], &q = vertices_g_[j], &r = vertices_g_[k];
  const double twice_area = (q.x() - p.x()) * (r.y() - p.y()) - (q.y() - p.y()) * (r.x() - p.x());
  if (!(twice_area < 0)) return;  // faces up, or stands upright
  const double slope_x =
      ((q.z() - p.z()) * (r.y() - p.y()) - (r.z() - p.z()) * (q.y() - p.y())) / twice_area;
  const double slope_y =
      ((r.z() - p.z()) * (q.x() - p.x()) - (q.z() - p.z()) * (r.x() - p.x())) / twice_area;
  const auto [low, high] = std::minmax({p.z(), q.z(), r.z()});
  const auto [x_low, x_high] = std::minmax({p.x(), q.x(), r.x()});
  const auto [y_low, y_high] = std::minmax({p.y(), q.y(), r.y()});
  const NodeRange x = Inside(x_low, x_high, nodes_x_), y = Inside(y_low, y_high, nodes_y_);
  for (int a = x.first; a <= x.last; ++a) {
    for (int b = y.first; b <= y.last; ++b) {
      if (LeftOf(vertices_g_, i, j, a, b) > 0 || LeftOf(vertices_g_, j, k, a, b) > 0 ||
          LeftOf(vertices_g_, k, i, a, b) > 0) {
        continue;
      }
      // A steep triangle's slopes are large: its corners bound what rounding makes of them.
      const double z = p.z() + slope_x * (a - p.x()) + slope_y * (b - p.y());
      double& lowest = lowest_[a * nodes_y_ + b];
      lowest = std::min(lowest, std::clamp(z, low, high));
    }
  }
}

void PlasticSinkageOfMesh(const Tire& tire, const TirePose& pose, const SurfacePatch& patch,
                          const SoilMap& soils, std::vector<NodeSinkage>* sinkage) {
  sinkage->clear();
  TreadCurves curves(soils, tire.shape);
  Underside underside;
  underside.Draw(*tire.mesh, {pose.centre_w, pose.frame_w}, patch);
  underside.Open();
  for (int a = 0; a < patch.nodes_x(); ++a) {
    for (int b = 0; b < patch.nodes_y(); ++b) {
      const double below = patch.Height(a, b) - underside.At(a, b);
      if (!(below > 0)) continue;
      const double by_slip = patch.SlipSinkage(a, b);
      PressedPoint point{below, patch.Sinkage(a, b) - by_slip, 1, 1};
      point.loose = patch.Loose(a, b);
      const GridNode node{patch.first().i + a, patch.first().j + b};
      const int soil = soils.NumberAt(node.i * patch.spacing(), node.j * patch.spacing());
      const PlateCurve& curve = curves.In(soil).below_lugs;
      const auto left = LeftBehind(curve, Equilibrium(tire.spring, curve, point), point);
      if (left) sinkage->push_back({node, by_slip + *left});
    }
  }
}

}  // namespace softsoil
