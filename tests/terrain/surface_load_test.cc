#include "terrain/surface_load.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <stdexcept>

#include "tests/terrain/written_bytes.h"

namespace softsoil {
namespace {

constexpr double kDx = 0.025;  // [m]

SurfaceLoad Mean(LoadGatherer& gatherer, double period) {
  SurfaceLoad load;
  gatherer.AddMean(
      0, period, [](GridNode) { return 0.0; }, &load);
  gatherer.Clear();
  return load;
}

// Forces around zero, so over four tiles at least.
std::vector<SurfaceForce> RandomForces(int count) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> unit(-1, 1);
  std::vector<SurfaceForce> forces;
  for (int i = 0; i < count; ++i) {
    forces.push_back({{unit(random), unit(random), 0},
                      {100 * unit(random), 100 * unit(random), 200 * unit(random) - 100}});
  }
  return forces;
}

TEST(SurfaceLoad, KeepsTheSumOfTheForces) {
  LoadGatherer gatherer(kDx);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double size = 0;
  for (const SurfaceForce& force : RandomForces(300)) {
    gatherer.Add(force, 0.01);
    sum += force.force_w;
    size += force.force_w.norm();
  }
  for (const NodeForce& f : Mean(gatherer, 0.01)) sum -= f.force_w;
  EXPECT_LT(sum.norm(), 1e-12 * size);
}

TEST(SurfaceLoad, KeepsTheMomentOfTheVerticalForces) {
  LoadGatherer gatherer(kDx);
  double about_x = 0, about_y = 0, size = 0;
  for (const SurfaceForce& force : RandomForces(300)) {
    gatherer.Add(force, 0.01);
    about_x += force.point_w.y() * force.force_w.z();
    about_y += force.point_w.x() * force.force_w.z();
    size += std::abs(force.force_w.z());
  }
  for (const NodeForce& f : Mean(gatherer, 0.01)) {
    about_x -= f.y * f.force_w.z();
    about_y -= f.x * f.force_w.z();
  }
  EXPECT_LT(std::hypot(about_x, about_y), 1e-12 * size);
}

TEST(SurfaceLoad, KeepsTheMomentOfHorizontalForcesAboutTheVertical) {
  LoadGatherer gatherer(kDx);
  double about_z = 0, size = 0;
  for (const SurfaceForce& force : RandomForces(300)) {
    gatherer.Add(force, 0.01);
    about_z += force.point_w.x() * force.force_w.y() - force.point_w.y() * force.force_w.x();
    size += force.force_w.norm();
  }
  for (const NodeForce& f : Mean(gatherer, 0.01)) {
    about_z -= f.x * f.force_w.y() - f.y * f.force_w.x();
  }
  EXPECT_LT(std::abs(about_z), 1e-12 * size);
}

TEST(SurfaceLoad, IsTheMeanOverThePeriod) {
  LoadGatherer gatherer(kDx);
  gatherer.Add({{0, 0, 0}, {0, 0, -100}}, 0.002);
  gatherer.Add({{0, 0, 0}, {0, 0, -300}}, 0.004);  // and nothing for the rest of 10 ms
  const SurfaceLoad load = Mean(gatherer, 0.01);
  ASSERT_EQ(load.size(), 1u);
  EXPECT_NEAR(load[0].force_w.z(), -140, 1e-12);
}

TEST(SurfaceLoad, StandsAtTheHeightOfTheSurface) {
  LoadGatherer gatherer(0.25);
  gatherer.Add({{-0.75, 1.75, 99}, {0, 0, -100}}, 0.01);
  SurfaceLoad load;
  gatherer.AddMean(
      2, 0.01, [](GridNode node) { return node.i + 100.0 * node.j; }, &load);
  ASSERT_EQ(load.size(), 1u);
  EXPECT_EQ(load[0].node.i, -3);
  EXPECT_EQ(load[0].node.j, 7);
  EXPECT_EQ(load[0].x, -0.75);
  EXPECT_EQ(load[0].y, 1.75);
  EXPECT_EQ(load[0].z, 697);
  EXPECT_EQ(load[0].source, 2);
}

TEST(SurfaceLoad, IsSharedByTheFourNodesAround) {
  LoadGatherer gatherer(kDx);
  gatherer.Add({{-0.25 * kDx, 0.5 * kDx, 0}, {0, 0, -80}}, 1);
  const SurfaceLoad load = Mean(gatherer, 1);
  ASSERT_EQ(load.size(), 4u);
  for (const NodeForce& f : load) EXPECT_NEAR(f.force_w.z(), f.node.i == -1 ? -10 : -30, 1e-12);
}

TEST(SurfaceLoad, StartsAnewAfterEveryPeriod) {
  LoadGatherer gatherer(kDx);
  gatherer.Add({{0, 0, 0}, {0, 0, -100}}, 0.01);
  EXPECT_EQ(Mean(gatherer, 0.01).size(), 1u);
  EXPECT_TRUE(Mean(gatherer, 0.01).empty());
}

constexpr double kMostImpulse = 100;  // [N s]

TEST(SurfaceLoad, GoesOnAlikeInACopyAndWhenWrittenAndRead) {
  const std::vector<SurfaceForce> forces = RandomForces(300);
  LoadGatherer plain(kDx);
  for (int i = 0; i < 150; ++i) plain.Add(forces[i], 0.01);
  LoadGatherer copy = plain, read(kDx);
  const std::vector<unsigned char> bytes = BytesOf(plain);
  StateReader reader(bytes.data(), bytes.size());
  read.Read(reader, kMostImpulse);
  EXPECT_EQ(BytesOf(read), bytes);
  for (LoadGatherer* gatherer : {&plain, &copy, &read}) {
    for (int i = 150; i < 300; ++i) gatherer->Add(forces[i], 0.01);
  }
  EXPECT_GT(BytesOf(plain).size(), bytes.size());
  EXPECT_EQ(BytesOf(copy), BytesOf(plain));
  EXPECT_EQ(BytesOf(read), BytesOf(plain));
}

// So that sums over a load have the same bits.
TEST(SurfaceLoad, IsInTheSameOrderHoweverItCameAbout) {
  LoadGatherer forward(kDx), backward(kDx);
  for (int k = -399; k <= 399; k += 7) {
    forward.Add({{k * kDx, -k % 50 * kDx, 0}, {0, 0, -100}}, 0.01);
    backward.Add({{-k * kDx, k % 50 * kDx, 0}, {0, 0, -100}}, 0.01);
  }
  EXPECT_EQ(BytesOf(forward), BytesOf(backward));
}

TEST(SurfaceLoad, IsRefusedWithANodeTwice) {
  LoadGatherer gatherer(kDx), read(kDx);
  gatherer.Add({{0.5 * kDx, 0, 0}, {0, 0, -100}}, 0.01);
  std::vector<unsigned char> bytes = BytesOf(gatherer);
  const std::size_t node = sizeof(std::uint64_t), next = node + sizeof(GridNode) + 24;
  std::copy_n(&bytes[node], sizeof(GridNode), &bytes[next]);
  StateReader reader(bytes.data(), bytes.size());
  EXPECT_THROW(read.Read(reader, kMostImpulse), std::runtime_error);
}

TEST(SurfaceLoad, IsRefusedWithMoreThanAnyLoad) {
  LoadGatherer gatherer(kDx), read(kDx);
  gatherer.Add({{0, 0, 0}, {0, 0, -1000}}, 0.01);
  const std::vector<unsigned char> bytes = BytesOf(gatherer);
  StateReader enough(bytes.data(), bytes.size()), too_little(bytes.data(), bytes.size());
  EXPECT_NO_THROW(read.Read(enough, 10));
  EXPECT_THROW(read.Read(too_little, 9.9), std::runtime_error);
}

}  // namespace
}  // namespace softsoil
