#include "plugin/mesh_geom.h"

#include "plugin/model_geometry.h"
#include "terrain/input_error.h"

namespace softsoil {
namespace {

TriangleMesh MeshNumber(const mjModel* m, int mesh) {
  TriangleMesh triangles;
  const float* vertex = m->mesh_vert + 3 * m->mesh_vertadr[mesh];
  for (int i = 0; i < m->mesh_vertnum[mesh]; ++i, vertex += 3) {
    triangles.vertices.emplace_back(vertex[0], vertex[1], vertex[2]);
  }
  const int* face = m->mesh_face + 3 * m->mesh_faceadr[mesh];
  for (int i = 0; i < m->mesh_facenum[mesh]; ++i, face += 3) {
    triangles.triangles.push_back({face[0], face[1], face[2]});
  }
  return WithVerticesMerged(triangles);
}

// Corner k is at +x, +y, +z where bit 0, 1, 2 of k is set.
TriangleMesh Box(const Eigen::Vector3d& half) {
  TriangleMesh box;
  for (int k = 0; k < 8; ++k) {
    const Eigen::Vector3d sign((k & 1) != 0 ? 1 : -1, (k & 2) != 0 ? 1 : -1, (k & 4) != 0 ? 1 : -1);
    box.vertices.emplace_back(half.cwiseProduct(sign));
  }
  box.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                   {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return box;
}

TriangleMesh InGeomFrame(const mjModel* m, int geom) {
  switch (m->geom_type[geom]) {
    case mjGEOM_MESH: return MeshNumber(m, m->geom_dataid[geom]);
    case mjGEOM_BOX: return Box(Vector(m->geom_size + 3 * geom));
    default: throw InputError("must be of type mesh or box");
  }
}

}  // namespace

bool HasMeshShape(const mjModel* m, int geom) {
  return m->geom_type[geom] == mjGEOM_MESH || m->geom_type[geom] == mjGEOM_BOX;
}

TriangleMesh MeshOfGeom(const mjModel* m, int geom) {
  return At(GeomName(m, geom), [&] {
    TriangleMesh mesh = InGeomFrame(m, geom);
    const Frame frame = FrameAt(m->geom_pos + 3 * geom, m->geom_quat + 4 * geom);
    for (Eigen::Vector3d& v : mesh.vertices) v = frame.position + frame.orientation * v;
    RequireClosed(mesh);
    return mesh;
  });
}

}  // namespace softsoil
