// Rigid wheels of triangles of the size of the tractor tire 18.4R38.
#pragma once

#include <limits>
#include <memory>

#include "tests/contact/mesh_samples.h"
#include "tests/contact/samples.h"

namespace softsoil {

// Smooth, or with 12 grousers as high as the lugs of that tire.
inline Tire MeshWheel(bool grousers) {
  const double height = grousers ? 0.038 : 1e-4;  // [m]
  const GrouserWheel wheel = {0.91 - height, 0.467, height, 0.012, 12, 10};
  Tire tire = AgriculturalTire();
  tire.name = grousers ? "mesh_12_grousers" : "mesh_smooth";
  tire.mesh = std::make_shared<TriangleMesh>(wheel.Mesh());
  tire.shape.crown_radius = std::numeric_limits<double>::infinity();
  tire.shape.radius = RadiusAboutY(*tire.mesh);
  tire.spring = {};
  tire.spring.linear = 2e7;
  tire.damping = 2e4;
  return tire;
}

}  // namespace softsoil
