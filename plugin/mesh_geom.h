// The shapes of geoms as triangle meshes: meshes of a model and boxes.
#pragma once

#include <mujoco/mujoco.h>

#include "contact/triangle_mesh.h"

namespace softsoil {

bool HasMeshShape(const mjModel* m, int geom);

// The closed mesh of a geom in the frame of its body. MuJoCo moves and turns the vertices of a mesh
// to its centre of mass and its axes of inertia, and the geom's frame with them, so that this is
// where the MJCF has put them, to the precision of a float; it also scales them. Throws InputError
// with the name of the geom if it is neither a mesh nor a box, or the mesh not closed.
TriangleMesh MeshOfGeom(const mjModel* m, int geom);

}  // namespace softsoil
