#include "contact/mesh_sinkage.h"

#include <gtest/gtest.h>

#include <random>

#include "tests/contact/mesh_samples.h"
#include "tests/contact/samples.h"

namespace softsoil {
namespace {

using Eigen::Vector3d;

constexpr double kGrid = 0.025;  // [m]
const GrouserWheel kWheel = {0.15, 0.1, 0.015, 0.004, 12, 5};

// A mesh over level ground of the height 0.
struct Drawn {
  Surface surface{kGrid, SurfaceMode::kFlow, Level};
  SurfacePatch patch;
  Underside underside;

  Drawn(const TriangleMesh& mesh, const MeshPose& pose) {
    const Shadow shadow = ShadowOf(mesh, pose);
    surface.CopyPatch(shadow.x_min, shadow.x_max, shadow.y_min, shadow.y_max, &patch);
    underside.Draw(mesh, pose, patch);
  }
  Vector3d Node(int a, int b) const {
    return {(patch.first().i + a) * kGrid, (patch.first().j + b) * kGrid, 0};
  }
  template <class Visit>
  void ForEach(const Visit& visit) const {
    for (int a = 0; a < patch.nodes_x(); ++a) {
      for (int b = 0; b < patch.nodes_y(); ++b) visit(Node(a, b), underside.At(a, b));
    }
  }
};

MeshPose Upright(double x, double y, double z) { return {{x, y, z}, Eigen::Matrix3d::Identity()}; }

// The lowest crossing of the vertical line through x, y with a mesh in its own frame, by brute
// force: a ray against each triangle (Moeller and Trumbore 1997).
double LowestCrossing(const TriangleMesh& mesh, const MeshPose& pose, double x, double y) {
  const Vector3d up = pose.frame_w.transpose() * Vector3d::UnitZ();
  const Vector3d foot = pose.frame_w.transpose() * (Vector3d(x, y, 0) - pose.origin_w);
  double lowest = kNothingAbove;
  for (const auto& [i, j, k] : mesh.triangles) {
    const Vector3d &a = mesh.vertices[i], e1 = mesh.vertices[j] - a, e2 = mesh.vertices[k] - a;
    const double determinant = e1.dot(up.cross(e2));
    if (std::abs(determinant) < 1e-15) continue;
    const Vector3d from = foot - a;
    const double u = from.dot(up.cross(e2)) / determinant;
    const double v = up.dot(from.cross(e1)) / determinant;
    if (u < 0 || v < 0 || u + v > 1) continue;
    lowest = std::min(lowest, e2.dot(from.cross(e1)) / determinant);
  }
  return lowest;
}

TEST(Underside, IsTheBottomOfABox) {
  const Drawn drawn(BoxMesh(0.33, 0.21, 0.1), Upright(0.01, 0.02, 0.03));
  int below = 0;
  drawn.ForEach([&](const Vector3d& node, double lowest) {
    const bool is_below = std::abs(node.x() - 0.01) <= 0.165 && std::abs(node.y() - 0.02) <= 0.105;
    below += is_below;
    if (is_below) {
      EXPECT_NEAR(lowest, -0.02, 1e-15);
    } else {
      EXPECT_EQ(lowest, kNothingAbove);
    }
  });
  EXPECT_EQ(below, 14 * 9);
}

// Grid nodes on the diagonals and the edges of the triangles.
TEST(Underside, HasNoGapsWhereGridNodesMeetEdges) {
  for (double angle : {0.0, kPi / 2, kPi, -kPi / 2}) {
    const MeshPose pose = {{0.3, -0.7, 0}, RotationAbout(Vector3d::UnitZ(), angle)};
    const Drawn drawn(BoxMesh(0.475, 0.475, 0.1), pose);
    int below = 0;
    drawn.ForEach([&](const Vector3d&, double lowest) { below += lowest < 0; });
    EXPECT_EQ(below, 19 * 19) << angle;
  }
}

TEST(Underside, IsWhatARayFromBelowMeets) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> between(-1, 1);
  const TriangleMesh wheel = kWheel.Mesh();
  int met = 0;
  for (int round = 0; round < 30; ++round) {
    const Vector3d axis(between(random), between(random), between(random));
    const MeshPose pose = {{between(random), between(random), 0.1 * between(random)},
                           RotationAbout(axis, kPi * between(random))};
    const Drawn drawn(wheel, pose);
    drawn.ForEach([&](const Vector3d& node, double lowest) {
      const double crossing = LowestCrossing(wheel, pose, node.x(), node.y());
      if (crossing > 0 && lowest == kNothingAbove) return;  // above the ground: not drawn
      ASSERT_EQ(std::isinf(lowest), std::isinf(crossing));
      if (std::isinf(lowest)) return;
      EXPECT_NEAR(lowest, crossing, 1e-9);
      met += lowest < 0;
    });
  }
  EXPECT_GT(met, 500);
}

TEST(Underside, ShowsAGrouserThatPointsDown) {
  GrouserWheel wheel = kWheel;
  wheel.thickness = 0.03;
  const MeshPose pose = {{0, 0, 0.15}, RotationAbout(Vector3d::UnitY(), kPi)};
  Drawn(wheel.Mesh(), pose).ForEach([&](const Vector3d& node, double lowest) {
    if (std::abs(node.y()) > 0.05) return;
    if (std::abs(node.x()) <= 0.015) {
      EXPECT_NEAR(lowest, -0.015, 1e-12);
    } else {
      EXPECT_GT(lowest, 0);
    }
  });
}

TEST(Underside, IsNothingInTheAir) {
  Drawn(BoxMesh(1, 1, 1), Upright(0, 0, 0.51)).ForEach([](const Vector3d&, double lowest) {
    EXPECT_EQ(lowest, kNothingAbove);
  });
}

TEST(Underside, MayReachBeyondThePatch) {
  const TriangleMesh box = BoxMesh(1, 1, 1);
  Surface surface(kGrid, SurfaceMode::kFlow, Level);
  SurfacePatch patch;
  surface.CopyPatch(-0.1, 0.1, 0.3, 0.7, &patch);
  Underside underside;
  underside.Draw(box, Upright(0, 0, 0.4), patch);
  for (int a = 0; a < patch.nodes_x(); ++a) {
    for (int b = 0; b < patch.nodes_y(); ++b) {
      const double y = (patch.first().j + b) * kGrid;
      EXPECT_EQ(std::isinf(underside.At(a, b)), y > 0.5 + 1e-9) << y;
    }
  }
}

}  // namespace
}  // namespace softsoil
