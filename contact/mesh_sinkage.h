// What of a mesh is lowest above each grid node: how deep a rigid shape presses the ground.
#pragma once

#include <limits>
#include <vector>

#include "contact/wheel_contact.h"

namespace softsoil {

constexpr double kNothingAbove = std::numeric_limits<double>::infinity();  // [m]

// Where a body is in the world.
struct MeshPose {
  Eigen::Vector3d origin_w;  // [m]
  Eigen::Matrix3d frame_w;   // [-]  columns: axes of the frame of the mesh
};

// The part of the x, y plane that a mesh is above of.
struct Shadow {
  double x_min, x_max, y_min, y_max;  // [m]
};
Shadow ShadowOf(const TriangleMesh& mesh, const MeshPose& pose);

// Heights of the underside of a mesh above the nodes of a patch.
class Underside {
 public:
  // Draws the triangles that face down and reach below the patch's highest point. Neighbours leave
  // no gap between them: their shared edge is the same to the bit.
  void Draw(const TriangleMesh& mesh, const MeshPose& pose, const SurfacePatch& patch);

  // Takes away what hangs down and is narrower than two nodes along x or y, as a morphological
  // opening does: the tip of a grouser cuts a slit, and no rut as wide as a cell of the grid.
  void Open();

  // Lowest height [m] of the mesh above the patch's node first + (a, b), kNothingAbove if there is
  // none that was drawn. Of a closed mesh the lowest face always faces down.
  double At(int a, int b) const { return lowest_[a * nodes_y_ + b]; }

 private:
  std::vector<Eigen::Vector3d> vertices_g_;  // grid frame: x, y in spacings from the patch's first
                                             // node, z [m] as in the world
  std::vector<double> lowest_;
  int nodes_x_ = 0, nodes_y_ = 0;

  void DrawTriangle(const std::array<int, 3>& corners);
};

// PlasticSinkage() of a tire with a mesh: of its underside above each grid node.
void PlasticSinkageOfMesh(const Tire& tire, const TirePose& pose, const SurfacePatch& patch,
                          const SoilMap& soils, std::vector<NodeSinkage>* sinkage);

}  // namespace softsoil
