// Reads triangle meshes from files.
#pragma once

#include <string>

#include "contact/triangle_mesh.h"

namespace softsoil {

// The closed mesh in a file: Wavefront OBJ (.obj) or STL (.stl), text or binary. Lengths in the
// file are in metres once multiplied by `scale` [-] > 0: 0.001 for millimetres.
//
// Of OBJ the vertices v and the faces f count, polygons as fans of triangles (which is right for
// convex ones); normals, textures, groups and materials do not matter. Of STL the normals do not:
// the order of the corners tells what is outside. Throws InputError with file and line, or file
// and triangle, also if the mesh is not what RequireClosed() wants.
TriangleMesh ReadMesh(const std::string& file, double scale = 1);

}  // namespace softsoil
