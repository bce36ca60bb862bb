#include "plugin/mesh_geom.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "terrain/input_error.h"
#include "tests/plugin/mjcf.h"

namespace softsoil {
namespace {

using Eigen::Vector3d;
using testing::HasSubstr;

// A wedge: a right triangle of the legs 1 and 2 m along x and z, extruded by 3 m along y.
const std::vector<Vector3d> kWedge = {{0, 0, 0}, {1, 0, 0}, {0, 0, 2},
                                      {0, 3, 0}, {1, 3, 0}, {0, 3, 2}};
constexpr char kWedgeAsset[] = R"(<asset><mesh name="wedge" scale=".1 .1 .1"
    vertex="0 0 0 1 0 0 0 0 2 0 3 0 1 3 0 0 3 2"
    face="0 1 2 3 5 4 0 3 4 0 4 1 1 4 5 1 5 2 2 5 3 2 3 0"/></asset>)";

TriangleMesh MeshIn(const std::string& body, const std::string& asset = kWedgeAsset) {
  const Model m = Load(World(body, asset));
  return MeshOfGeom(m.get(), 0);
}

double DistanceTo(const Vector3d& point, const TriangleMesh& mesh) {
  double least = 1e9;
  for (const Vector3d& v : mesh.vertices) least = std::min(least, (v - point).norm());
  return least;
}

std::string Refusal(const std::string& body, const std::string& asset = kWedgeAsset) {
  try {
    MeshIn(body, asset);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(MeshGeom, IsWhereTheModelPutsItInItsBody) {
  const TriangleMesh mesh = MeshIn(R"(<body pos="7 8 9" euler="10 20 30">
      <geom type="mesh" mesh="wedge" pos=".5 -.25 .125" euler="0 0 90"/></body>)");
  ASSERT_EQ(mesh.vertices.size(), 6u);
  ASSERT_EQ(mesh.triangles.size(), 8u);
  for (const Vector3d& corner : kWedge) {
    const Vector3d expected =
        Vector3d(.5, -.25, .125) + 0.1 * Vector3d(-corner.y(), corner.x(), corner.z());
    EXPECT_LT(DistanceTo(expected, mesh), 1e-6) << expected.transpose();
  }
  EXPECT_NEAR(Volume(mesh), 0.003, 1e-8);
}

TEST(MeshGeom, MayBeABox) {
  const TriangleMesh mesh =
      MeshIn(R"(<body><geom type="box" size=".1 .2 .3" pos="1 0 0" euler="0 0 90"/></body>)");
  EXPECT_NEAR(Volume(mesh), 8 * 0.006, 1e-12);
  EXPECT_NEAR(Area(mesh), 8 * (0.02 + 0.03 + 0.06), 1e-12);
  EXPECT_LT(DistanceTo({1.2, 0.1, -0.3}, mesh), 1e-12);
}

TEST(MeshGeom, IsRefusedIfItHasNoTriangles) {
  EXPECT_EQ(Refusal(R"(<body><geom name="ball" type="sphere" size=".1"/></body>)"),
            "geom \"ball\": must be of type mesh or box");
}

TEST(MeshGeom, IsRefusedIfItIsOpen) {
  std::string open = kWedgeAsset;
  const std::string last = " 2 3 0";
  open.erase(open.find(last), last.size());
  EXPECT_THAT(Refusal(R"(<body><geom name="w" type="mesh" mesh="wedge"/></body>)", open),
              HasSubstr("geom \"w\": triangle "));
  EXPECT_THAT(Refusal(R"(<body><geom name="w" type="mesh" mesh="wedge"/></body>)", open),
              HasSubstr("the mesh is open there"));
}

}  // namespace
}  // namespace softsoil
