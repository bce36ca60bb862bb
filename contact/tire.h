// A tire: an elastic surface of revolution that rubs on soil.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "contact/lugs.h"
#include "contact/tire_spring.h"
#include "contact/triangle_mesh.h"
#include "terrain/xml_catalogue.h"

namespace softsoil {

constexpr double kWidestPerRadius = 10;  // [-]  of a tire's width
constexpr double kSameSize = 0.01;       // [-]  of a mesh and the shape that bounds it

// Torus, outer radius r at the middle of the tread; its cross-section is an arc of the crown
// radius r_beta. A cylinder has an infinite crown radius. Madsen (2014) section 4.2.
struct TireShape {
  double radius;        // [m]  r, > 0
  double crown_radius;  // [m]  r_beta, >= width / 2; infinity for a cylinder
  double width;         // [m]  b, > 0
  Lugs lugs = {};       // none if left out
};

struct Tire {
  std::string name, description;
  TireShape shape;
  TireSpring spring;
  double damping;        // [Pa s/m]  pressure per speed at which the wheel nears the ground, >= 0
  double soil_friction;  // [-]  mu_s between tire and soil, > 0
  std::string family;    // one tire at several inflation pressures; empty: not known
  double inflation_pressure = 0;  // [Pa]  above the atmosphere's; > 0 in a family
  // Surface in the tire frame, if it is not that of the shape, which then bounds it; or null.
  std::shared_ptr<const TriangleMesh> mesh = nullptr;
};

// What is wrong with a shape, as a rule and the value; empty if nothing is.
std::string ShapeFault(const TireShape& shape);

// An empty catalogue for files such as models/tires/agricultural.xml.
Catalogue<Tire> TireCatalogue();

// The numbers of a tire file that every tire has. <shape type="torus"> has a crown_radius besides;
// <inflation family="..." pressure="..."/> [Pa] and <lugs> (contact/lugs.h) may stand in any, or
// instead of both <mesh file="wheel.obj" scale="0.001"/>: the surface, a closed mesh of that file
// (contact/mesh_file.h), which is looked for from the folder of the XML file. Its y axis is the
// spin axis, and radius and width are those of the shape, a cylinder, to kSameSize.
const std::vector<Attribute<Tire>>& TireAttributes();

}  // namespace softsoil
