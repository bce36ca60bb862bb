// Meshes for tests, with what is known of them in closed form.
#pragma once

#include <cmath>
#include <string>

#include "contact/triangle_mesh.h"
#include "terrain/constants.h"

namespace softsoil {

inline void AddQuad(const std::array<int, 4>& corners, TriangleMesh* mesh) {
  mesh->triangles.push_back({corners[0], corners[1], corners[2]});
  mesh->triangles.push_back({corners[0], corners[2], corners[3]});
}

// Edges a, b, c [m] along x, y, z, centred.
inline TriangleMesh BoxMesh(double a, double b, double c) {
  TriangleMesh box;
  for (double z : {-c / 2, c / 2}) {
    box.vertices.insert(
        box.vertices.end(),
        {{-a / 2, -b / 2, z}, {a / 2, -b / 2, z}, {a / 2, b / 2, z}, {-a / 2, b / 2, z}});
  }
  AddQuad({3, 2, 1, 0}, &box);
  AddQuad({4, 5, 6, 7}, &box);
  for (int k = 0; k < 4; ++k) AddQuad({k, (k + 1) % 4, (k + 1) % 4 + 4, k + 4}, &box);
  return box;
}

// By parallels and meridians.
inline TriangleMesh SphereMesh(double radius, int parallels, int meridians) {
  TriangleMesh sphere;
  sphere.vertices = {{0, 0, -radius}, {0, 0, radius}};
  for (int i = 1; i <= parallels; ++i) {
    const double beta = kPi * i / (parallels + 1) - kPi / 2;
    for (int k = 0; k < meridians; ++k) {
      const double theta = 2 * kPi * k / meridians;
      sphere.vertices.emplace_back(radius * std::cos(beta) * std::cos(theta),
                                   radius * std::cos(beta) * std::sin(theta),
                                   radius * std::sin(beta));
    }
  }
  const auto at = [&](int i, int k) { return 2 + (i - 1) * meridians + k % meridians; };
  for (int k = 0; k < meridians; ++k) {
    sphere.triangles.push_back({0, at(1, k + 1), at(1, k)});
    sphere.triangles.push_back({1, at(parallels, k), at(parallels, k + 1)});
    for (int i = 1; i < parallels; ++i) {
      AddQuad({at(i, k), at(i, k + 1), at(i + 1, k + 1), at(i + 1, k)}, &sphere);
    }
  }
  return sphere;
}

// A wheel about y with straight grousers across it: its outline is a polygon, `width` [m] wide.
struct GrouserWheel {
  double radius, width, height, thickness;  // [m]  of the drum, of a grouser
  int grousers, facets;                     // facets: of the drum, between two grousers

  // Corners of the outline in the x, z plane, clockwise seen along +y.
  std::vector<Eigen::Vector3d> Outline() const {
    std::vector<Eigen::Vector3d> outline;
    const double pitch = 2 * kPi / grousers, half = std::asin(thickness / 2 / radius);
    for (int g = 0; g < grousers; ++g) {
      const Eigen::Vector3d out(std::sin(g * pitch), 0, std::cos(g * pitch));
      const Eigen::Vector3d along(std::cos(g * pitch), 0, -std::sin(g * pitch));
      const double foot = radius * std::cos(half);
      outline.push_back(foot * out - thickness / 2 * along);
      outline.push_back((radius + height) * out - thickness / 2 * along);
      outline.push_back((radius + height) * out + thickness / 2 * along);
      outline.push_back(foot * out + thickness / 2 * along);
      for (int f = 1; f < facets; ++f) {
        const double theta = g * pitch + half + (pitch - 2 * half) * f / facets;
        outline.emplace_back(radius * std::sin(theta), 0, radius * std::cos(theta));
      }
    }
    return outline;
  }

  TriangleMesh Mesh() const {
    TriangleMesh mesh;
    const std::vector<Eigen::Vector3d> outline = Outline();
    const int n = static_cast<int>(outline.size());
    mesh.vertices = {{0, -width / 2, 0}, {0, width / 2, 0}};
    for (double y : {-width / 2, width / 2}) {
      for (const Eigen::Vector3d& p : outline) mesh.vertices.emplace_back(p.x(), y, p.z());
    }
    for (int k = 0; k < n; ++k) {
      const int next = (k + 1) % n;
      mesh.triangles.push_back({0, 2 + next, 2 + k});
      mesh.triangles.push_back({1, 2 + n + k, 2 + n + next});
      AddQuad({2 + k, 2 + next, 2 + n + next, 2 + n + k}, &mesh);
    }
    return mesh;
  }

  double PolygonArea() const {  // [m^2]
    const double pitch = 2 * kPi / grousers, half = std::asin(thickness / 2 / radius);
    const double facet = (pitch - 2 * half) / facets;
    const double drum = radius * radius / 2 * (facets * std::sin(facet) + std::sin(2 * half));
    return grousers * (drum + thickness * (radius + height - radius * std::cos(half)));
  }
  double Perimeter() const {  // [m]
    const double pitch = 2 * kPi / grousers, half = std::asin(thickness / 2 / radius);
    const double facet = (pitch - 2 * half) / facets;
    const double flank = radius + height - radius * std::cos(half);
    return grousers * (2 * flank + thickness + facets * 2 * radius * std::sin(facet / 2));
  }
};

// As a text STL file.
inline std::string TextStl(const TriangleMesh& mesh) {
  const auto row = [](const Eigen::Vector3d& v) {
    return "    vertex " + std::to_string(v.x()) + " " + std::to_string(v.y()) + " " +
           std::to_string(v.z()) + "\n";
  };
  std::string text = "solid made by a test\n";
  for (const auto& [a, b, c] : mesh.triangles) {
    text += "facet normal 0 0 0\n  outer loop\n" + row(mesh.vertices[a]) + row(mesh.vertices[b]) +
            row(mesh.vertices[c]) + "  endloop\nendfacet\n";
  }
  return text + "endsolid made by a test\n";
}

// As an OBJ file; corners are numbered from 1, or from the end of the list.
inline std::string Obj(const TriangleMesh& mesh, bool from_the_end = false) {
  std::string text = "# made by a test\no shape\n";
  for (const Eigen::Vector3d& v : mesh.vertices) {
    text += "v " + std::to_string(v.x()) + " " + std::to_string(v.y()) + " " +
            std::to_string(v.z()) + "\n";
  }
  const int first = from_the_end ? -static_cast<int>(mesh.vertices.size()) : 1;
  for (const std::array<int, 3>& corners : mesh.triangles) {
    text += "f";
    for (const int corner : corners) text += " " + std::to_string(corner + first);
    text += "\n";
  }
  return text;
}

}  // namespace softsoil
