// The surface of a mesh as a cloud of nodes, fixed to its body.
#pragma once

#include <vector>

#include "contact/triangle_mesh.h"

namespace softsoil {

// Arrays by quantity, in the frame of the mesh.
struct MeshNodes {
  std::vector<Eigen::Vector3d> position_t;  // [m]
  std::vector<Eigen::Vector3d> normal_t;    // [-]  outward
  std::vector<Eigen::Vector3d> tangent_t;   // [-]  any direction along the surface
  std::vector<Eigen::Vector3d> binormal_t;  // [-]  normal x tangent
  std::vector<double> area;                 // [m^2]

  std::size_t size() const { return area.size(); }
};

constexpr int kMostNodes = 1000000;

// Nodes of a closed mesh, about `spacing` [m] > 0 apart; their areas add up to that of the mesh.
//
// A triangle larger than that is halved across its longest edge until its parts are small enough,
// and each part is a node. Smaller triangles are gathered with their neighbours beyond an edge as
// long as the surface does not turn by more than kSmoothTurn: a node never spans the edge of a
// grouser, and a plate however thin has nodes on both faces. Throws InputError if there would be
// more than kMostNodes.
MeshNodes MakeMeshNodes(const TriangleMesh& mesh, double spacing);

constexpr double kSmoothTurn = 0.35;  // [rad]  20 degrees, from the first triangle of a node

}  // namespace softsoil
