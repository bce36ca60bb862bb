// The surface of a mesh as a cloud of nodes, as that of a tire.
#pragma once

#include "contact/tire_nodes.h"
#include "contact/triangle_mesh.h"

namespace softsoil {

constexpr int kMostNodes = 1000000;

// Nodes of a closed mesh, about `spacing` [m] > 0 apart; their areas add up to that of the mesh but
// for what lies within another of its parts.
//
// Triangles are halved across their longest edge until they are much smaller than that, and the
// pieces in a cube of the spacing make a node, as far as they hang together without an edge that
// turns by more than kSmoothTurn: a node never spans the edge of a grouser, and a plate however
// thin has nodes on both faces. The y axis of the mesh is the spin axis; tangents lie across it.
// Throws InputError if there would be more than kMostNodes.
TireNodes MakeMeshNodes(const TriangleMesh& mesh, double spacing);

constexpr double kSmoothTurn = 0.35;  // [rad]  20 degrees, also within a node

}  // namespace softsoil
