#include "contact/mesh_nodes.h"

#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <numeric>
#include <utility>

#include "terrain/input_error.h"
#include "tests/contact/mesh_samples.h"

namespace softsoil {
namespace {

using Eigen::Vector3d;

const GrouserWheel kWheel = {0.15, 0.1, 0.015, 0.004, 12, 5};

double TotalArea(const TireNodes& nodes) {
  return std::accumulate(nodes.area.begin(), nodes.area.end(), 0.0);
}

TEST(MeshNodes, CoverTheMeshExactlyAtAnySpacing) {
  for (const TriangleMesh& mesh :
       {BoxMesh(0.3, 0.2, 0.01), SphereMesh(0.3, 40, 80), kWheel.Mesh()}) {
    for (double spacing : {0.1, 0.025, 0.005}) {
      EXPECT_NEAR(TotalArea(MakeMeshNodes(mesh, spacing)) / Area(mesh), 1, 1e-12);
    }
  }
}

// Under one pressure all around a closed shape does not move. A node on the drum of the wheel has
// one normal where the drum is curved.
TEST(MeshNodes, BalanceOneFlatFaceAgainstTheOther) {
  for (const auto& [mesh, most] :
       {std::pair(BoxMesh(0.3, 0.2, 0.01), 1e-12), std::pair(kWheel.Mesh(), 1e-6)}) {
    const TireNodes nodes = MakeMeshNodes(mesh, 0.02);
    Vector3d force = Vector3d::Zero(), torque = Vector3d::Zero();
    double volume = 0;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      force += nodes.area[i] * nodes.normal_t[i];
      torque += nodes.area[i] * nodes.position_t[i].cross(nodes.normal_t[i]);
      volume += nodes.area[i] * nodes.position_t[i].dot(nodes.normal_t[i]) / 3;
    }
    EXPECT_NEAR(force.norm() / Area(mesh), 0, most);
    EXPECT_NEAR(torque.norm() / Area(mesh), 0, most);
    EXPECT_NEAR(volume / Volume(mesh), 1, 1e-2);
  }
}

TriangleMesh Together(TriangleMesh mesh, const TriangleMesh& other) {
  const int first = static_cast<int>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
  for (const std::array<int, 3>& t : other.triangles) {
    mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  }
  return mesh;
}

// A hub in its wheel, and an axle that sticks out by 0.1 m on either side of it.
TEST(MeshNodes, AreNoneWithinAnotherPart) {
  const TriangleMesh wheel = SphereMesh(0.3, 20, 40);
  for (const double size : {0.999, 0.5}) {
    TriangleMesh hub = wheel;
    for (Vector3d& v : hub.vertices) v *= size;
    EXPECT_NEAR(TotalArea(MakeMeshNodes(Together(wheel, hub), 0.03)) / Area(wheel), 1, 1e-12);
  }
  const TriangleMesh axle = BoxMesh(0.1, 0.8, 0.1);
  const double out = 2 * (4 * 0.1 + 0.1) * 0.1, covered = 2 * 0.1 * 0.1;
  EXPECT_NEAR(TotalArea(MakeMeshNodes(Together(wheel, axle), 0.02)), Area(wheel) + out - covered,
              0.1 * out);
}

TEST(MeshNodes, HaveRightAngledUnitFrames) {
  const TireNodes nodes = MakeMeshNodes(SphereMesh(0.3, 40, 80), 0.03);
  ASSERT_GT(nodes.size(), 500u);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    Eigen::Matrix3d frame;
    frame << nodes.normal_t[i], nodes.tangent_t[i], nodes.binormal_t[i];
    EXPECT_TRUE(frame.isUnitary(1e-12)) << i;
    EXPECT_NEAR(frame.determinant(), 1, 1e-12) << i;
  }
}

TEST(MeshNodes, HaveTheOutwardNormalOfASphere) {
  for (double spacing : {0.1, 0.02}) {  // gathered, and halved
    const TireNodes nodes = MakeMeshNodes(SphereMesh(0.3, 20, 40), spacing);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      EXPECT_GT(nodes.normal_t[i].dot(nodes.position_t[i].normalized()), 0.99);
      EXPECT_NEAR(nodes.position_t[i].norm(), 0.3, 0.006);
    }
  }
}

TEST(MeshNodes, StandOnTheFacesOfABoxWithTheirNormals) {
  const Vector3d half(0.15, 0.1, 0.005);
  const TireNodes nodes = MakeMeshNodes(BoxMesh(0.3, 0.2, 0.01), 0.025);
  Eigen::Matrix<double, 3, 2> area = Eigen::Matrix<double, 3, 2>::Zero();
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    Eigen::Index axis = 0;
    EXPECT_NEAR(nodes.normal_t[i].cwiseAbs().maxCoeff(&axis), 1, 1e-12);
    const double side = nodes.normal_t[i][axis];
    EXPECT_NEAR(nodes.position_t[i][axis], side * half[axis], 1e-15);
    area(axis, side > 0) += nodes.area[i];
  }
  for (int side : {0, 1}) {
    EXPECT_NEAR(area(0, side), 0.2 * 0.01, 1e-15);
    EXPECT_NEAR(area(1, side), 0.3 * 0.01, 1e-15);
    EXPECT_NEAR(area(2, side), 0.3 * 0.2, 1e-15);
  }
}

TEST(MeshNodes, StandAboutTheirSpacingApart) {
  const TriangleMesh coarse = BoxMesh(0.5, 0.5, 0.5), fine = SphereMesh(0.3, 200, 400);
  for (const TriangleMesh& mesh : {coarse, fine}) {
    const double each = Area(mesh) / MakeMeshNodes(mesh, 0.025).size();
    EXPECT_GT(each, 0.025 * 0.025 / 3);
    EXPECT_LT(each, 0.025 * 0.025);
  }
}

// Nodes far apart still know the tip, the flanks and the foot of a grouser.
TEST(MeshNodes, StandOnEveryFaceOfAGrouser) {
  const TireNodes nodes = MakeMeshNodes(kWheel.Mesh(), 0.05);
  double tip = 0, ahead = 0, behind = 0;  // area at the uppermost grouser
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const Vector3d &p = nodes.position_t[i], &n = nodes.normal_t[i];
    if (p.z() < 0.151 || std::abs(p.x()) > 0.01) continue;
    if (n.z() > 0.99) tip += nodes.area[i];
    if (n.x() > 0.99) ahead += nodes.area[i];
    if (n.x() < -0.99) behind += nodes.area[i];
  }
  const double foot = std::sqrt(0.15 * 0.15 - 0.002 * 0.002);
  EXPECT_NEAR(tip, 0.004 * 0.1, 1e-12);
  EXPECT_NEAR(ahead, (0.165 - foot) * 0.1, 1e-12);
  EXPECT_NEAR(behind, (0.165 - foot) * 0.1, 1e-12);
}

TEST(MeshNodes, AreRefusedIfThereWouldBeTooMany) {
  EXPECT_THAT([] { MakeMeshNodes(BoxMesh(50, 50, 50), 0.01); },
              testing::ThrowsMessage<InputError>(
                  "the mesh must have at most 1000000 nodes, got more: the grid spacing is too "
                  "fine for its area"));
}

}  // namespace
}  // namespace softsoil
