// A closed surface of triangles: the shape of anything that meets the ground, from a lugged tire to
// the belly of a vehicle.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

namespace softsoil {

constexpr double kLargestMesh = 100;  // [m]  along an axis

struct TriangleMesh {
  std::vector<Eigen::Vector3d> vertices;      // [m]
  std::vector<std::array<int, 3>> triangles;  // vertices, counter-clockwise seen from outside
};

// Outward normal of a triangle times its area [m^2], and its centroid [m].
Eigen::Vector3d AreaVector(const TriangleMesh& mesh, int triangle);
Eigen::Vector3d Centroid(const TriangleMesh& mesh, int triangle);

// The box that a mesh fills, along its axes.
struct Extent {
  Eigen::Vector3d low, high;  // [m]

  Eigen::Vector3d Middle() const { return (low + high) / 2; }
  Eigen::Vector3d Size() const { return high - low; }
};
Extent ExtentOf(const TriangleMesh& mesh);
double RadiusAboutY(const TriangleMesh& mesh);  // [m]  of its farthest vertex

double Area(const TriangleMesh& mesh);    // [m^2]
double Volume(const TriangleMesh& mesh);  // [m^3]  that a closed mesh encloses

// The mesh with one vertex in place of those that are, along every axis, closer than a millionth of
// its size: files of triangles repeat every corner, rounded to the last digit of a float.
TriangleMesh WithVerticesMerged(const TriangleMesh& mesh);

// By triangle and by corner k: the triangle beyond the edge from corner k to the next. Throws
// InputError unless every edge has two triangles that run along it in opposite directions.
std::vector<std::array<int, 3>> Neighbours(const TriangleMesh& mesh);

// Throws InputError unless the mesh is what the ground can meet: triangles of finite corners and of
// an area, at most kLargestMesh, closed, and each of its connected parts turned outward. A cavity
// is a part turned inward, and refused: soil does not get there. Triangles are numbered from 1.
void RequireClosed(const TriangleMesh& mesh);

// A part of the mesh for every set of triangles that hang together: by triangle its part, from 0.
std::vector<int> Parts(const std::vector<std::array<int, 3>>& neighbours);

}  // namespace softsoil
