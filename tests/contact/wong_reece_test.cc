#include "contact/wong_reece.h"

#include <gmock/gmock.h>

#include "tests/contact/wong_reece_case.h"

namespace softsoil {
namespace {

const std::vector<LoadedWheel> kCases = {
    CompactSand1967(), LooseSand1967(6, 1986),       LooseSand1967(12, 2085),
    Azimi2013(),       TilledYoloLoam(0.575, 18000), FirmYoloLoam(0.67, 27000)};

// Load, thrust, motion resistance and torque by the trapezoidal rule along the rim.
struct RimSums {
  double load = 0, thrust = 0, motion_resistance = 0, torque = 0;
};
RimSums SumsOf(const LoadedWheel& c, const std::vector<RimStress>& rim) {
  RimSums sums;
  for (std::size_t k = 0; k + 1 < rim.size(); ++k) {
    for (const RimStress& s : {rim[k], rim[k + 1]}) {
      const double area = c.wheel.radius * c.wheel.width * (rim[k + 1].angle - rim[k].angle) / 2;
      sums.load += area * (s.pressure * std::cos(s.angle) + s.shear * std::sin(s.angle));
      sums.thrust += area * s.shear * std::cos(s.angle);
      sums.motion_resistance += area * s.pressure * std::sin(s.angle);
      sums.torque += area * c.wheel.radius * s.shear;
    }
  }
  return sums;
}

void ExpectStressesToGiveTheForces(const LoadedWheel& c, const WongReece& rolling) {
  const RimSums sums = SumsOf(c, StressAlongRim(c.wheel, c.soil, rolling, 20001));
  EXPECT_NEAR(sums.load / c.load, 1, 1e-5);
  EXPECT_NEAR((sums.thrust - rolling.thrust) / c.load, 0, 1e-5);
  EXPECT_NEAR((sums.motion_resistance - rolling.motion_resistance) / c.load, 0, 1e-5);
  EXPECT_NEAR((sums.torque - rolling.torque) / (c.load * c.wheel.radius), 0, 1e-5);
}

TEST(WongReece, CarriesTheLoad) {
  for (const LoadedWheel& c : kCases) {
    for (double slip : {0.0, 0.1, 1.0}) {
      EXPECT_NEAR(DrivenAt(slip, c).load / c.load, 1, 1e-12);
    }
    EXPECT_NEAR(Towed(c).load / c.load, 1, 1e-12);
  }
}

TEST(WongReece, StressesAlongTheRimGiveTheForces) {
  for (const LoadedWheel& c : kCases) {
    for (double slip : {0.0, 0.1, 1.0}) ExpectStressesToGiveTheForces(c, DrivenAt(slip, c));
    ExpectStressesToGiveTheForces(c, Towed(c));
  }
}

TEST(WongReece, PullRisesWithSlipUpToFifteenPercent) {
  for (const LoadedWheel& c : kCases) {
    for (double slip = 0.01; slip < 0.151; slip += 0.01) {
      EXPECT_GT(DrivenAt(slip, c).drawbar_pull, DrivenAt(slip - 0.01, c).drawbar_pull) << slip;
    }
  }
}

// Beyond, a wheel on loose sand sinks so much deeper that motion resistance outgrows the thrust.
TEST(WongReece, PullFallsAgainWhereTheWheelDigsItselfIn) {
  const WongReece rolling = DrivenAt(0.2, LooseSand1967(6, 1986));
  const WongReece digging = DrivenAt(0.5, LooseSand1967(6, 1986));
  EXPECT_LT(digging.drawbar_pull, rolling.drawbar_pull);
  EXPECT_GT(digging.sinkage, rolling.sinkage);
  EXPECT_GT(digging.motion_resistance, rolling.motion_resistance);
}

TEST(WongReece, WheelSinksDeeperUnderMoreLoadAndIfNarrower) {
  for (const LoadedWheel& c : kCases) {
    for (double share = 0.1; share < 1.05; share += 0.1) {
      LoadedWheel lighter = c, heavier = c;
      lighter.load *= share;
      heavier.load *= share + 0.1;
      LoadedWheel narrower = lighter;
      narrower.wheel.width *= 0.9;
      const double sinkage = DrivenAt(0.2, lighter).sinkage;
      EXPECT_LT(sinkage, DrivenAt(0.2, heavier).sinkage);
      EXPECT_LT(sinkage, DrivenAt(0.2, narrower).sinkage);
      EXPECT_LT(Towed(lighter).sinkage, Towed(heavier).sinkage);
    }
  }
}

TEST(WongReece, TowedWheelHasNoTorqueAndMustBePulled) {
  for (const LoadedWheel& c : kCases) {
    const WongReece towed = Towed(c);
    EXPECT_NEAR(towed.torque / (c.load * c.wheel.radius), 0, 1e-9);
    EXPECT_LT(towed.slip, 0);
    EXPECT_LT(towed.drawbar_pull, 0);
    EXPECT_LT(towed.max_stress_angle, towed.entry_angle);
  }
}

// Shear drives a towed wheel in front of theta_0 and brakes it behind. Equation 2.20 says where.
TEST(WongReece, ShearOnATowedWheelChangesSignWhereTheSoilParts) {
  for (const LoadedWheel& c : kCases) {
    const WongReece towed = Towed(c);
    const double theta_0 = towed.max_stress_angle, phi = c.soil.shear.friction_angle;
    EXPECT_NEAR((std::cos(theta_0) - 1 / (1 - towed.slip)) / std::sin(theta_0),
                std::tan(kPi / 4 - phi / 2), 1e-12);
    for (const RimStress& s : StressAlongRim(c.wheel, c.soil, towed, 100)) {
      EXPECT_GE(s.shear * (s.angle - theta_0), 0) << s.angle;
    }
  }
}

TEST(WongReece, StressIsZeroAtTheEntryAndOffTheContact) {
  for (const LoadedWheel& c : kCases) {
    for (const WongReece& rolling : {DrivenAt(0.2, c), Towed(c)}) {
      for (double angle : {rolling.entry_angle, rolling.entry_angle + 0.1, -0.1}) {
        const RimStress s = StressAt(c.wheel, c.soil, rolling, angle);
        EXPECT_EQ(s.pressure, 0);
        EXPECT_EQ(s.shear, 0);
      }
      EXPECT_EQ(StressAt(c.wheel, c.soil, rolling, 0).pressure, 0);
    }
  }
}

TEST(WongReece, StressIsContinuousAndPressureGreatestAtThetaM) {
  for (const LoadedWheel& c : kCases) {
    for (const WongReece& rolling : {DrivenAt(0.2, c), Towed(c)}) {
      const double theta_m = rolling.max_stress_angle;
      const RimStress at = StressAt(c.wheel, c.soil, rolling, theta_m);
      const double depth = c.wheel.radius * (std::cos(theta_m) - std::cos(rolling.entry_angle));
      EXPECT_NEAR(at.pressure / BearingPressure(c.soil.bearing_modulus, c.soil.n, depth), 1, 1e-12);
      for (double beside : {-1e-9, 1e-9}) {
        const RimStress near = StressAt(c.wheel, c.soil, rolling, theta_m + beside);
        EXPECT_NEAR(near.pressure / at.pressure, 1, 1e-7);
        EXPECT_NEAR((near.shear - at.shear) / at.pressure, 0, 1e-6);
      }
      for (const RimStress& s : StressAlongRim(c.wheel, c.soil, rolling, 100)) {
        EXPECT_LE(s.pressure, at.pressure);
      }
    }
  }
}

// Mohr-Coulomb, equation 2.3; reached once the soil has sheared by many K.
TEST(WongReece, ShearNeverExceedsTheStrengthOfTheSoil) {
  for (LoadedWheel c : kCases) {
    const auto strength = [&](const RimStress& s) {
      return c.soil.shear.cohesion + s.pressure * std::tan(c.soil.shear.friction_angle);
    };
    for (const WongReece& rolling : {DrivenAt(0.2, c), DrivenAt(1, c), Towed(c)}) {
      for (const RimStress& s : StressAlongRim(c.wheel, c.soil, rolling, 100)) {
        EXPECT_LE(std::abs(s.shear), strength(s));
      }
    }
    c.soil.shear.modulus = 1e-4;
    const RimStress s = StressAt(c.wheel, c.soil, DrivenAt(1, c), 0.05);
    EXPECT_NEAR(s.shear / strength(s), 1, 1e-12);
  }
}

// Without shear, for n = 1 and theta_m at the bottom: sigma = k_e r (cos theta - cos theta_1) all
// along the rim, hence W = k_e r^2 b (theta_1 / 2 - sin(2 theta_1) / 4) and R = k_e r^2 b
// (1 - cos theta_1)^2 / 2.
TEST(WongReece, HasAClosedFormOnFrictionlessSoil) {
  const RigidWheel wheel = {0.5, 0.2};
  const SoilUnderRim soil = {1e6, 1, {0, 0, 0.01}, {1e-12, 0}};
  const double theta = 0.7, scale = 1e6 * 0.5 * 0.5 * 0.2;
  const double load = scale * (theta / 2 - std::sin(2 * theta) / 4);
  const WongReece rolling = DrivenWheel(wheel, soil, load, 0.3);
  EXPECT_NEAR(rolling.entry_angle, theta, 1e-9);
  EXPECT_NEAR(rolling.sinkage, 0.5 * (1 - std::cos(theta)), 1e-9);
  EXPECT_NEAR(rolling.motion_resistance, scale * (1 - std::cos(theta)) * (1 - std::cos(theta)) / 2,
              1e-5);
  EXPECT_EQ(rolling.thrust, 0);
  EXPECT_EQ(rolling.torque, 0);
}

// Equation 2.8; beyond the peak the residual.
TEST(WongReece, ShearFollowsAHumpIfTheSoilHasOne) {
  LoadedWheel c = TilledYoloLoam(0.575, 18000);
  const WongReece smooth = DrivenAt(0.2, c);
  c.soil.shear.form = ShearForm::kHumped;
  c.soil.shear.residual = 0.4;
  const WongReece humped = DrivenAt(0.2, c);
  EXPECT_NE(humped.thrust, smooth.thrust);
  ExpectStressesToGiveTheForces(c, humped);
  ExpectStressesToGiveTheForces(c, Towed(c));
  for (const RimStress& s : StressAlongRim(c.wheel, c.soil, humped, 50)) {
    const double theta_1 = humped.entry_angle;
    const double x = c.wheel.radius / c.soil.shear.modulus *
                     (theta_1 - s.angle - 0.8 * (std::sin(theta_1) - std::sin(s.angle)));
    const double hump = x * std::exp(1 - x), share = x < 1 ? hump : 0.4 + 0.6 * hump;
    const double strength = 7100 + s.pressure * std::tan(21.17 * kDegree);
    EXPECT_NEAR(s.shear, strength * share, 1e-6) << s.angle;
  }
}

TEST(WongReece, SlipDefinitionsAgree) {
  const double r = 0.9, spin = 1.5, v = 1;
  EXPECT_NEAR(SlipFromSae((r * spin - v) / v), 1 - v / (r * spin), 1e-15);
  for (double s : {-0.5, 0.0, 0.3, 4.0}) EXPECT_NEAR(SaeFromSlip(SlipFromSae(s)), s, 1e-14);
}

}  // namespace
}  // namespace softsoil
