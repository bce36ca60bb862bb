// The Wong-Reece wheel against the independent solution and against published numbers.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "tests/contact/wong_reece_case.h"
#include "tests/reference/wong_reece_oracle.h"

namespace softsoil {
namespace {

using softsoil_reference::SteadyRolling;
using softsoil_reference::SteadyWheel;

SteadyWheel ForTheOracle(const LoadedWheel& c) {
  const Shear& shear = c.soil.shear;
  return {c.wheel.radius, c.wheel.width,        c.soil.bearing_modulus, c.soil.n,
          shear.cohesion, shear.friction_angle, shear.modulus,          c.load};
}

void ExpectSame(const LoadedWheel& c, const WongReece& ours, const SteadyRolling& theirs) {
  constexpr double kBand = 1e-6;
  const double r = c.wheel.radius;
  EXPECT_NEAR(ours.entry_angle / theirs.entry_angle, 1, kBand);
  EXPECT_NEAR(ours.max_stress_angle / theirs.max_stress_angle, 1, kBand);
  EXPECT_NEAR(ours.sinkage / theirs.sinkage, 1, 2 * kBand);  // grows with the square of the angle
  EXPECT_NEAR(ours.load / c.load, theirs.load / c.load, kBand);
  EXPECT_NEAR(ours.thrust / c.load, theirs.thrust / c.load, kBand);
  EXPECT_NEAR(ours.motion_resistance / c.load, theirs.motion_resistance / c.load, kBand);
  EXPECT_NEAR(ours.drawbar_pull / c.load, theirs.drawbar_pull / c.load, kBand);
  EXPECT_NEAR(ours.torque / (c.load * r), theirs.torque / (c.load * r), kBand);
}

// Soils from nearly rigid-plastic (n 0.1) to fluffy, frictionless clay and sand.
const SoilUnderRim kSoils[] = {
    {4.7e5, 0.47, {689, 33.3 * kDegree, 0.0381}, {0.43, 0.32}},
    {1.05e6, 0.85, {7100, 21.17 * kDegree, 0.0106}, {0.43, 0.32}},
    {4.2e6, 1.0, {35720, 23.13 * kDegree, 0.0106}, {0.18, 0.32}},
    {5.4e5, 1.15, {827, 31.1 * kDegree, 0.0381}, {0.18, 0.32}},
    {1.6e6, 0.13, {68950, 34 * kDegree, 0.006}, {0.38, 0.41}},
    {3e5, 0.5, {20000, 0, 0.01}, {0.3, 0.1}},
    {8e5, 0.1, {100, 5 * kDegree, 0.001}, {0.05, 0.5}},
};
const RigidWheel kWheels[] = {{0.15, 0.1}, {0.62738, 0.1524}, {0.91, 0.575}};

// A load that is this share of the pressure k_e r^n on the area r b.
LoadedWheel Loaded(const RigidWheel& wheel, const SoilUnderRim& soil, double share) {
  return {
      wheel, soil,
      share * soil.bearing_modulus * std::pow(wheel.radius, soil.n) * wheel.radius * wheel.width};
}

std::string Named(const LoadedWheel& c) {
  return "radius " + std::to_string(c.wheel.radius) + " n " + std::to_string(c.soil.n) + " load " +
         std::to_string(c.load);
}

TEST(WongReeceOracle, AgreesOnDrivenWheels) {
  for (const RigidWheel& wheel : kWheels) {
    for (const SoilUnderRim& soil : kSoils) {
      for (double share : {0.003, 0.03, 0.2}) {
        const LoadedWheel c = Loaded(wheel, soil, share);
        SCOPED_TRACE(Named(c));
        for (double slip : {0.0, 0.02, 0.3, 1.0}) {
          const MaxStress place = soil.max_stress;
          ExpectSame(c, DrivenAt(slip, c),
                     softsoil_reference::Driven(ForTheOracle(c), place.c_1, place.c_2, slip));
        }
      }
    }
  }
}

TEST(WongReeceOracle, AgreesOnTowedWheels) {
  for (const SoilUnderRim& soil : kSoils) {
    for (const auto& [wheel, share] : {std::pair(kWheels[0], 0.2), std::pair(kWheels[2], 0.01)}) {
      const LoadedWheel c = Loaded(wheel, soil, share);
      SCOPED_TRACE(Named(c));
      const SteadyRolling theirs = softsoil_reference::Towed(ForTheOracle(c));
      ExpectSame(c, Towed(c), theirs);
      EXPECT_NEAR(-Towed(c).slip / theirs.skid, 1, 1e-6);
    }
  }
}

// Wong and Reece (1967), wheel on compact sand at 22.1 % slip. The parameters are published; these
// results are the rounded ones of an independent calculation with them.
TEST(WongReece1967, DrivenWheelOnCompactSand) {
  const WongReece rolling = DrivenAt(0.221, CompactSand1967());
  EXPECT_NEAR(rolling.entry_angle / kDegree, 36.5, 0.05);
  EXPECT_NEAR(rolling.max_stress_angle / kDegree, 18.3, 0.05);
  EXPECT_NEAR(rolling.sinkage / kInch, 4.86, 0.005);
  EXPECT_NEAR(rolling.drawbar_pull / kPoundForce, 291, 0.5);
  EXPECT_NEAR(rolling.torque / (kPoundForce * kInch), 22600, 0.5);
}

TEST(WongReece1967, DrivenWheelsOnLooseSand) {
  const WongReece narrow = DrivenAt(0.221, LooseSand1967(6, 1986));
  EXPECT_NEAR(narrow.entry_angle / kDegree, 56.07, 0.005);
  EXPECT_NEAR(narrow.drawbar_pull / kPoundForce, 236, 0.5);
  EXPECT_NEAR(narrow.torque / (kPoundForce * kInch), 25522, 0.5);
  const WongReece wide = DrivenAt(0.221, LooseSand1967(12, 2085));
  EXPECT_NEAR(wide.entry_angle / kDegree, 47.27, 0.005);
  EXPECT_NEAR(wide.drawbar_pull / kPoundForce, 347, 0.5);
  EXPECT_NEAR(wide.torque / (kPoundForce * kInch), 25995, 0.5);
}

// Part II of the paper publishes a skid of 0.18; its own equations have no torque at 0.172.
TEST(WongReece1967, TowedWheelOnCompactSand) {
  const WongReece towed = Towed(CompactSand1967());
  EXPECT_NEAR(-towed.slip, 0.172, 0.0005);
  EXPECT_NEAR(-towed.slip, 0.18, 0.05 * 0.18);
  EXPECT_NEAR(towed.entry_angle / kDegree, 36.86, 0.005);
  EXPECT_NEAR(towed.max_stress_angle / kDegree, 12.99, 0.005);
  EXPECT_NEAR(-towed.drawbar_pull / kPoundForce, 632, 0.5);
}

// The parameters of Azimi, Kovecses and Angeles (2013), Table III, at 20 % slip; the results of a
// public computation with them, read off its graph.
TEST(Azimi2013, RoverWheelOnSand) {
  const LoadedWheel c = Azimi2013();
  const WongReece rolling = DrivenAt(0.2, c);
  EXPECT_NEAR(rolling.entry_angle / kDegree, 45.3, 0.05);
  EXPECT_NEAR(rolling.max_stress_angle / kDegree, 11, 0.1);
  double pressure = 0, shear = 0;
  for (const RimStress& s : StressAlongRim(c.wheel, c.soil, rolling, 1000)) {
    pressure = std::max(pressure, s.pressure);
    shear = std::max(shear, s.shear);
  }
  EXPECT_NEAR(pressure, 20300, 100);
  EXPECT_NEAR(shear, 10500, 100);
}

// Madsen (2014) section 6.3.2 prints its own Wong-Reece results. The thesis does not say which
// slip, width and K it took. Read here: the slip of equation 4.8, the contact widths 0.575 and
// 0.67 m, and K at its mean plus its standard deviation; no other reading of the printed
// parameters comes closer.
struct ThesisCase {
  LoadedWheel wheel;
  double slip;          // [-]    SAE
  double drawbar_pull;  // [N]
  double torque;        // [N m]
};

void ExpectNearThesis(double ours, double thesis) { EXPECT_NEAR(ours / thesis, 1, 0.12); }

TEST(MadsenWongReece, TilledSoilWithinTwelvePercent) {
  const ThesisCase cases[] = {
      {TilledYoloLoam(0.575, 18000), 0.1, 2900, 6000},
      {TilledYoloLoam(0.575, 18000), 0.7, 3600, 7300},
      {TilledYoloLoam(0.575, 27000), 0.1, 3700, 9200},
      {TilledYoloLoam(0.575, 27000), 0.7, 3800, 10500},
      {TilledYoloLoam(0.67, 18000), 0.1, 3000, 5600},
      {TilledYoloLoam(0.67, 18000), 0.7, 4000, 7200},
      {TilledYoloLoam(0.67, 27000), 0.1, 3700, 8700},
      {TilledYoloLoam(0.67, 27000), 0.7, 4200, 10200},
  };
  for (const ThesisCase& c : cases) {
    const WongReece rolling = DrivenAt(SlipFromSae(c.slip), c.wheel);
    ExpectNearThesis(rolling.drawbar_pull, c.drawbar_pull);
    ExpectNearThesis(rolling.torque, c.torque);
  }
}

// Of the four values on firm soil this one alone. With the printed cohesion of 35.72 kPa, the mean
// of two measured sets, the others come out too high: the pull by 14 % at 10 % slip (5.70 against
// 5.0 kN) and by 24 % at 70 % (9.30 against 7.5 kN), the torque at 70 % by 14 % (10.65 against 9.3
// kN m). Read otherwise, with i = s or the mean K, they stay too high.
TEST(MadsenWongReece, TorqueOnFirmSoilAtLowSlipWithinTwelvePercent) {
  ExpectNearThesis(DrivenAt(SlipFromSae(0.1), FirmYoloLoam(0.575, 18000)).torque, 6500);
}

}  // namespace
}  // namespace softsoil
