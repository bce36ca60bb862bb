// Soils, tires, grounds and poses for the tests of contact/.
#pragma once

#include <string>

#include "contact/wheel_contact.h"

namespace softsoil {

inline Soil SoilNamed(const std::string& name) {
  Catalogue<Soil> soils = SoilCatalogue();
  soils.AddFolder(SOFTSOIL_SOURCE_DIR "/models/soils");
  return soils.Find(name);
}

inline Tire TireNamed(const std::string& name) {
  Catalogue<Tire> tires = TireCatalogue();
  tires.AddFolder(SOFTSOIL_SOURCE_DIR "/models/tires");
  return tires.Find(name);
}

inline Soil TilledLoam() { return SoilNamed("tilled_yolo_loam"); }
inline Tire AgriculturalTire() { return TireNamed("18.4R38_85kPa"); }  // torus, root spring
inline Tire TruckTire() { return TireNamed("37x12.5R16.5_15psi"); }    // cylinder, linear spring

inline Tire Undamped(Tire tire) {
  tire.damping = 0;
  return tire;
}

// Bears everything: a tire meets it as it meets a plate.
inline Soil Rock() {
  Soil soil = SoilNamed("firm_yolo_loam");
  soil.bearing = {0, 1e15, 1};
  soil.compaction.initial_density = 3 * soil.compaction.reference_density;
  return soil;
}

inline double Level(double, double) { return 0; }

// A plane that rises by `slope` [-] along x.
inline UndisturbedHeight Rising(double slope) {
  return [slope](double x, double) { return slope * x; };
}

// Upright, facing x, at rest.
inline TirePose PoseAt(double x, double y, double z) {
  return {{x, y, z}, Eigen::Matrix3d::Identity(), Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
}
// Pressed `depth` [m] into level ground of height 0.
inline TirePose PressedIn(const Tire& tire, double depth) {
  return PoseAt(0, 0, tire.shape.radius - depth);
}

inline Eigen::Matrix3d RotationAbout(const Eigen::Vector3d& axis, double angle) {
  return Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
}

// The pose in a world that is rotated about the origin.
inline TirePose Rotated(const Eigen::Matrix3d& rotation, const TirePose& pose) {
  return {rotation * pose.centre_w, rotation * pose.frame_w, rotation * pose.velocity_w,
          rotation * pose.angular_velocity_w};
}

// |a - b| as a share of |b|.
inline double RelativeError(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return (a - b).norm() / b.norm();
}

}  // namespace softsoil
