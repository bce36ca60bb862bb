// The surface of a mesh as a cloud of nodes, as that of a tire.
#pragma once

#include "contact/tire_nodes.h"
#include "contact/triangle_mesh.h"

namespace softsoil {

constexpr int kMostNodes = 1000000;

// Nodes of a closed mesh, about `spacing` [m] > 0 apart; their areas add up to that of the mesh.
//
// A triangle larger than that is halved across its longest edge until its parts are small enough,
// and each part is a node. Smaller triangles are gathered with their neighbours beyond an edge as
// long as the surface does not turn by more than kSmoothTurn: a node never spans the edge of a
// grouser, and a plate however thin has nodes on both faces. The y axis of the mesh is the spin
// axis; tangents lie across it. Throws InputError if there would be more than kMostNodes.
TireNodes MakeMeshNodes(const TriangleMesh& mesh, double spacing);

constexpr double kSmoothTurn = 0.35;  // [rad]  20 degrees, from the first triangle of a node

}  // namespace softsoil
