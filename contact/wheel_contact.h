// The contact of one wheel with soft ground. Force is a question: Evaluate() changes nothing.
// The rut and the slip memory are events: Commit() is called once per accepted time step.
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "contact/equilibrium.h"
#include "contact/slip_memory.h"
#include "contact/tire_nodes.h"
#include "terrain/plate_curve.h"
#include "terrain/shear.h"
#include "terrain/soil_map.h"
#include "terrain/surface.h"
#include "terrain/surface_load.h"

namespace softsoil {

// Where a wheel is and how it moves. The tire frame turns with the wheel; its y axis is the spin
// axis and points to the left of the vehicle.
struct TirePose {
  Eigen::Vector3d centre_w;            // [m]      on the spin axis, middle of the tread
  Eigen::Matrix3d frame_w;             // [-]      columns: axes of the tire frame
  Eigen::Vector3d velocity_w;          // [m/s]    of the centre
  Eigen::Vector3d angular_velocity_w;  // [rad/s]
};

// Force [N] and torque [N m] on the wheel in world axes; torque taken about `at_w` [m].
struct Wrench {
  Eigen::Vector3d force_w = Eigen::Vector3d::Zero();
  Eigen::Vector3d torque_w = Eigen::Vector3d::Zero();
  Eigen::Vector3d at_w = Eigen::Vector3d::Zero();
};

// The same wrench about another point.
Wrench About(const Wrench& wrench, const Eigen::Vector3d& at_w);

// One node in contact.
struct NodeContact {
  int node;                        // of TireNodes
  int soil;                        // of the SoilMap: what the node stands in
  Eigen::Vector3d point_w;         // [m]   of the deformed tire
  Eigen::Vector3d normal_force_w;  // [N]   on the wheel, from the pressure
  Eigen::Vector3d shear_force_w;   // [N]   on the wheel
  Eigen::Vector3d flank_force_w;   // [N]   on the wheel, at the edges of its tread: flank.h
  double pressure, area;           // [Pa], [m^2]
  double depth;                    // [m]   below the undisturbed ground
  double slip_sinkage;             // [m]   of the soil in this step
  Mobilisation mobilisation;       // at the end of the step
  Mobilisation mobilised;          // a moment later: of the strength
  double tread_pressure;           // [Pa]  mean of lugs and gaps around; `pressure` without lugs
  double engaged;                  // [m]   height of the soil that stands between the lugs
  double strength;                 // [Pa]  largest shear stress
  double side_strength;            // [N]   besides, on the side of the tread at its edges
  double pushed;                   // [-]   of the passive pressure mobilised; of meshes
};

// Answer of Evaluate(). Reused between calls, so that evaluating soon allocates nothing.
struct PatchForces {
  Wrench wrench;                      // about the wheel centre
  std::vector<NodeContact> contacts;  // in the order of the nodes
  std::vector<SurfaceForce> surface;  // on the ground, one per contact
  SurfacePatch patch;                 // the surface below the wheel and one node around
};

// The shear stress is that of a moment later [s], as if the slip went on: a viscous share. Without
// it a wheel that swings on a slope would go on swinging, and creep down. While driving it must
// not count, so it looks no further ahead than a share [-] of the shear modulus K.
constexpr double kShearLead = 0.005;
constexpr double kLongestLead = 0.05;

class WheelContact {
 public:
  // node_spacing [m] > 0 of the tire surface; the grid spacing is a good choice.
  WheelContact(const Tire& tire, double node_spacing);

  const Tire& tire() const { return tire_; }
  const TireNodes& nodes() const { return nodes_; }

  // Forces at a pose, if the state is held for the step h [s]. Throws std::runtime_error if the
  // pose is not finite or more than 1000 km away.
  void Evaluate(const TirePose& pose, const Surface& surface, const SoilMap& soils, double h,
                PatchForces* forces) const;

  // Keeps the slip memory of the step; nodes that have left the ground forget theirs.
  void Commit(const PatchForces& forces);

  SlipMemory Slip() const;
  void SetSlip(const SlipMemory& slip);

  // Forgets all slip.
  void Reset();

 private:
  // Normal contact of one node; false if it is above the ground.
  bool Press(int node, const TirePose& pose, const SurfacePatch& patch, TreadCurves* curves,
             NodeContact* contact) const;
  // Pressure and depth of a node, with or without lugs; how far [m] it stays pressed in.
  double Balance(const TreadCurve& curve, const PressedPoint& point, double damping,
                 NodeContact* contact) const;
  // Slip of a node that is pressed.
  void Mobilise(const TirePose& pose, double h, double K, NodeContact* contact) const;
  // [m]  in this step
  double SlipSinkageOf(const NodeContact& contact, const TreadCurve& curve, const Soil& soil) const;
  Eigen::Vector3d ShearForce(const TirePose& pose, const Shear& soil,
                             const NodeContact& contact) const;

  Tire tire_;
  TireNodes nodes_;
  std::vector<Mobilisation> mobilisation_;  // by node
  std::vector<double> deepest_;             // [m]  by node, of the lug tips; empty without lugs
};

}  // namespace softsoil
