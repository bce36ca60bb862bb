#include "contact/triangle_mesh.h"

#include <gmock/gmock.h>

#include "terrain/input_error.h"
#include "tests/contact/mesh_samples.h"
#include "tests/contact/samples.h"

namespace softsoil {
namespace {

using Eigen::Vector3d;
using testing::HasSubstr;

const GrouserWheel kWheel = {0.15, 0.1, 0.015, 0.004, 12, 5};

std::string Refusal(const TriangleMesh& mesh) {
  try {
    RequireClosed(mesh);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TriangleMesh Moved(TriangleMesh mesh, const Vector3d& by) {
  for (Vector3d& v : mesh.vertices) v += by;
  return mesh;
}

TriangleMesh Together(TriangleMesh a, const TriangleMesh& b) {
  const int first = static_cast<int>(a.vertices.size());
  a.vertices.insert(a.vertices.end(), b.vertices.begin(), b.vertices.end());
  for (const auto& [i, j, k] : b.triangles) {
    a.triangles.push_back({first + i, first + j, first + k});
  }
  return a;
}

TriangleMesh InsideOut(TriangleMesh mesh) {
  for (std::array<int, 3>& corners : mesh.triangles) std::swap(corners[0], corners[1]);
  return mesh;
}

TEST(TriangleMesh, KnowsAreaAndVolumeOfABox) {
  const TriangleMesh box = Moved(BoxMesh(0.3, 0.2, 0.1), {5, -3, 2});
  EXPECT_NEAR(Area(box), 2 * (0.06 + 0.03 + 0.02), 1e-14);
  EXPECT_NEAR(Volume(box), 0.006, 1e-14);
  EXPECT_EQ(Refusal(box), "");
}

TEST(TriangleMesh, KnowsAreaAndVolumeOfAWheelWithGrousers) {
  const TriangleMesh wheel = kWheel.Mesh();
  EXPECT_NEAR(Volume(wheel), kWheel.PolygonArea() * kWheel.width, 1e-12);
  EXPECT_NEAR(Area(wheel), 2 * kWheel.PolygonArea() + kWheel.Perimeter() * kWheel.width, 1e-12);
  EXPECT_EQ(Refusal(wheel), "");
}

TEST(TriangleMesh, ApproachesASphereWithTheSquareOfItsTriangles) {
  const auto error = [](int n) {
    return 1 - Volume(SphereMesh(0.4, n, 2 * n)) / (4 * kPi / 3 * std::pow(0.4, 3));
  };
  EXPECT_LT(error(40), 0.01);
  EXPECT_NEAR(error(20) / error(40), 4, 0.2);
}

TEST(TriangleMesh, HasNormalsThatPointOutward) {
  const TriangleMesh sphere = SphereMesh(0.4, 20, 40);
  for (int t = 0; t < static_cast<int>(sphere.triangles.size()); ++t) {
    EXPECT_GT(AreaVector(sphere, t).normalized().dot(Centroid(sphere, t).normalized()), 0.99);
  }
}

TEST(TriangleMesh, HasNeighboursBeyondEveryEdge) {
  const TriangleMesh wheel = kWheel.Mesh();
  const auto neighbours = Neighbours(wheel);
  for (int t = 0; t < static_cast<int>(wheel.triangles.size()); ++t) {
    for (int k = 0; k < 3; ++k) {
      const auto& beyond = wheel.triangles[neighbours[t][k]];
      for (const int corner : {wheel.triangles[t][k], wheel.triangles[t][(k + 1) % 3]}) {
        EXPECT_NE(std::find(beyond.begin(), beyond.end(), corner), beyond.end());
      }
    }
  }
}

TEST(TriangleMesh, MergesVerticesThatFilesRepeat) {
  const TriangleMesh wheel = kWheel.Mesh();
  TriangleMesh soup;
  double jitter = 0;
  for (const std::array<int, 3>& corners : wheel.triangles) {
    const int first = static_cast<int>(soup.vertices.size());
    for (const int corner : corners) {
      jitter = jitter > 0 ? -1e-8 : 1e-8;
      soup.vertices.push_back(wheel.vertices[corner] + Vector3d(jitter, -jitter, jitter));
    }
    soup.triangles.push_back({first, first + 1, first + 2});
  }
  EXPECT_THAT(Refusal(soup), HasSubstr("open"));
  const TriangleMesh merged = WithVerticesMerged(soup);
  EXPECT_EQ(merged.vertices.size(), wheel.vertices.size());
  EXPECT_EQ(Refusal(merged), "");
  EXPECT_NEAR(Volume(merged), Volume(wheel), 1e-7 * Volume(wheel) + 1e-9);
}

TEST(TriangleMesh, MergesNothingThatIsApart) {
  const TriangleMesh sphere = SphereMesh(1000, 60, 120);
  EXPECT_EQ(WithVerticesMerged(sphere).vertices.size(), sphere.vertices.size());
  EXPECT_EQ(WithVerticesMerged(sphere).triangles, sphere.triangles);
}

TEST(TriangleMesh, MayBeOfSeveralParts) {
  const TriangleMesh two = Together(BoxMesh(1, 1, 1), Moved(BoxMesh(1, 1, 1), {3, 0, 0}));
  EXPECT_EQ(Refusal(two), "");
  const std::vector<int> parts = Parts(Neighbours(two));
  EXPECT_EQ(std::count(parts.begin(), parts.end(), 0), 12);
  EXPECT_EQ(std::count(parts.begin(), parts.end(), 1), 12);
}

TEST(BrokenMesh, IsRefusedWithoutTriangles) {
  EXPECT_EQ(Refusal({}), "there must be triangles, got none");
}

TEST(BrokenMesh, IsRefusedIfOpen) {
  TriangleMesh box = BoxMesh(1, 1, 1);
  box.triangles.pop_back();
  EXPECT_THAT(Refusal(box),
              HasSubstr("triangle 11: its edge from (-0.5, 0.5, -0.5) to (-0.5, -0.5, 0.5)"));
  EXPECT_THAT(Refusal(box),
              HasSubstr("must be shared by 2 triangles, got 1: the mesh is open there"));
}

TEST(BrokenMesh, IsRefusedIfThreeTrianglesShareAnEdge) {
  TriangleMesh box = BoxMesh(1, 1, 1);
  box.vertices.emplace_back(5, 5, 5);
  box.triangles.push_back({0, 1, 8});
  EXPECT_EQ(Refusal(box),
            "triangle 2: its edge from (-0.5, -0.5, -0.5) to (0.5, -0.5, -0.5) must be shared by 2 "
            "triangles, got 3: the mesh is not a surface there");
}

TEST(BrokenMesh, IsRefusedIfOneTriangleIsTurnedOver) {
  TriangleMesh box = BoxMesh(1, 1, 1);
  std::swap(box.triangles[6][0], box.triangles[6][1]);
  EXPECT_THAT(Refusal(box), HasSubstr("must run against that of triangle"));
  EXPECT_THAT(Refusal(box), HasSubstr("got the same direction: one of the two is inside out"));
}

TEST(BrokenMesh, IsRefusedIfInsideOut) {
  EXPECT_EQ(
      Refusal(InsideOut(BoxMesh(1, 2, 3))),
      "triangle 1: the 12 triangles connected to it must enclose a volume > 0 m^3, got -6: it "
      "is inside out; corners must be counter-clockwise seen from outside, and there must be "
      "no cavity");
}

TEST(BrokenMesh, IsRefusedIfOnePartIsInsideOutOrACavity) {
  const TriangleMesh hollow = Together(BoxMesh(3, 3, 3), InsideOut(BoxMesh(1, 1, 1)));
  EXPECT_THAT(Refusal(hollow), HasSubstr("triangle 13: the 12 triangles connected to it"));
  EXPECT_THAT(Refusal(hollow), HasSubstr("got -1: it is inside out"));
}

TEST(BrokenMesh, IsRefusedIfItEnclosesNothing) {
  const TriangleMesh sheet = {{{0, 0, 0.1}, {1, 0.1, 0.3}, {0.3, 1, 0.7}}, {{0, 1, 2}, {0, 2, 1}}};
  EXPECT_THAT(Refusal(sheet), HasSubstr("must enclose a volume > 0 m^3, got "));
}

TEST(BrokenMesh, IsRefusedIfATriangleHasNoArea) {
  TriangleMesh box = BoxMesh(1, 1, 1);
  box.triangles[4] = {0, 1, 1};
  EXPECT_EQ(Refusal(box), "triangle 5: its area must be > 0 m^2, got 0 at (0.166667, -0.5, -0.5)");
  box = BoxMesh(1, 1, 1);
  box.vertices.emplace_back(0, -0.5, -0.5);  // on the edge from 0 to 1
  box.triangles.push_back({0, 1, 8});
  EXPECT_THAT(Refusal(box), HasSubstr("triangle 13: its area must be > 0 m^2, got 0"));
}

TEST(BrokenMesh, IsRefusedIfACornerIsNotFinite) {
  TriangleMesh box = BoxMesh(1, 1, 1);
  box.vertices[6].y() = NAN;
  EXPECT_THAT(Refusal(box), HasSubstr("its corners must be finite, got an area of "));
}

TEST(BrokenMesh, IsRefusedIfItSeemsToBeInMillimetres) {
  EXPECT_EQ(Refusal(BoxMesh(300, 200, 100)),
            "the mesh must be at most 100 m long, got 300 m; is it in millimetres?");
}

}  // namespace
}  // namespace softsoil
