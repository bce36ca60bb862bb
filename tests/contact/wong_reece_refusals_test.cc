// What the rigid wheel of Wong and Reece refuses, and what it carries just before.
#include <gmock/gmock.h>

#include <limits>

#include "contact/wong_reece.h"
#include "terrain/input_error.h"
#include "tests/contact/wong_reece_case.h"

namespace softsoil {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

template <class Change>
void ExpectRefused(const Change& change, const std::string& message) {
  LoadedWheel c = CompactSand1967();
  change(c);
  EXPECT_THAT([&] { DrivenAt(0.2, c); }, ThrowsMessage<InputError>(message));
  EXPECT_THAT([&] { Towed(c); }, ThrowsMessage<InputError>(message));
}

TEST(WongReece, RefusesNumbersOutOfRange) {
  using C = LoadedWheel;
  ExpectRefused([](C& c) { c.wheel.radius = 0; }, "radius must be > 0 m and finite, got 0");
  ExpectRefused([](C& c) { c.wheel.width = kNan; }, "width must be > 0 m and finite, got nan");
  ExpectRefused([](C& c) { c.soil.bearing_modulus = -1; },
                "bearing modulus must be > 0 N/m^(n+2) and finite, got -1");
  ExpectRefused([](C& c) { c.soil.n = 0; }, "n must be > 0 and finite, got 0");
  ExpectRefused([](C& c) { c.soil.shear.modulus = 0; },
                "shear modulus must be > 0 m and finite, got 0");
  ExpectRefused([](C& c) { c.soil.shear.cohesion = -3; }, "cohesion must be >= 0 Pa, got -3");
  ExpectRefused([](C& c) { c.soil.shear.friction_angle = kPi / 2; },
                "friction angle must be 0 to below 90 deg, got 90");
  ExpectRefused([](C& c) { c.load = kInfinity; }, "load must be > 0 N and finite, got inf");
  ExpectRefused([](C& c) { c.load = -5; }, "load must be > 0 N and finite, got -5");
  ExpectRefused([](C& c) { c.soil.bearing_modulus = 1e308, c.wheel.radius = 1e308; },
                "k_e r^n must be > 0 Pa and finite, got inf");
}

TEST(WongReece, RefusesASlipThatADrivenWheelCannotHave) {
  for (double slip : {-0.1, 1.5, kNan}) {
    EXPECT_THAT([&] { DrivenAt(slip, CompactSand1967()); },
                ThrowsMessage<InputError>("slip must be 0 to 1, got " + Shown(slip)));
  }
}

TEST(WongReece, RefusesAMaxStressOffTheContact) {
  LoadedWheel c = CompactSand1967();
  for (double c_1 : {-0.5, 0.9, kNan}) {
    c.soil.max_stress.c_1 = c_1;
    EXPECT_THAT([&] { DrivenAt(0.5, c); },
                ThrowsMessage<InputError>(
                    HasSubstr("theta_m / theta_1 = c_1 + c_2 i must be > 0 and < 1, got ")));
    EXPECT_LT(Towed(c).drawbar_pull, 0);  // which needs none
  }
}

TEST(WongReece, RefusesALoadThatTheSoilCannotCarry) {
  LoadedWheel c = CompactSand1967();
  c.load *= 100;
  const auto rule = HasSubstr(" N, which the soil carries at an entry angle of 89 deg, got 892313");
  EXPECT_THAT([&] { DrivenAt(0.2, c); }, ThrowsMessage<InputError>(rule));
  EXPECT_THAT([&] { Towed(c); }, ThrowsMessage<InputError>(rule));
}

TEST(WongReece, CarriesAlmostTheMostThatItSays) {
  LoadedWheel c = CompactSand1967();
  c.load = 1e9;
  try {
    DrivenAt(0.2, c);
    FAIL();
  } catch (const InputError& error) {
    c.load = std::stod(std::string(error.what()).substr(std::string("load must be < ").size()));
  }
  EXPECT_THROW(DrivenAt(0.2, c), InputError);
  c.load *= 1 - 1e-9;
  EXPECT_NEAR(DrivenAt(0.2, c).entry_angle, 89 * kDegree, 1e-6);
}

// Clay that loses its strength after a hump: no towed wheel without torque beyond some entry.
LoadedWheel OnBrittleClay(double modulus, double load) {
  const Shear shear = {50000, 3 * kDegree, modulus, ShearForm::kHumped, 0};
  return {{0.5, 0.3}, {1e5, 0.3, shear, {0.4, 0.3}}, load};
}

TEST(WongReece, TowsWhereNoSteeperEntryHasARim) {
  double deepest = 0;
  for (const double load : {100.0, 3000.0, 6000.0}) {
    const WongReece towed = Towed(OnBrittleClay(0.05, load));
    EXPECT_NEAR(towed.load / load, 1, 1e-9);
    EXPECT_NEAR(towed.torque / (0.5 * load), 0, 1e-6);
    EXPECT_GT(towed.sinkage, deepest);
    deepest = towed.sinkage;
  }
  EXPECT_THAT([] { Towed(OnBrittleClay(0.05, 8000)); },
              ThrowsMessage<InputError>(testing::MatchesRegex(
                  "load must be < [0-9.]+ N, which the soil carries at an entry angle of 5[0-9] "
                  "deg, got 8000")));
}

// The least sinkage of those that carry the load, and none where the load jumps over it.
TEST(WongReece, CarriesTheLoadOrRefusesIt) {
  int carried = 0, refused = 0;
  for (double load = 250; load < 13000; load += 750) {
    try {
      const WongReece towed = Towed(OnBrittleClay(0.003, load));
      EXPECT_NEAR(towed.load / load, 1, 1e-6) << load;
      EXPECT_LT(towed.entry_angle, (load < 1900 ? 38 : 89) * kDegree) << load;
      ++carried;
    } catch (const InputError& error) {
      EXPECT_GT(load, 1900) << error.what();
      ++refused;
    }
  }
  EXPECT_GE(carried, 3);
  EXPECT_GT(refused, 5);
}

TEST(WongReece, RefusesToTowOnSoilWithoutStrength) {
  LoadedWheel c = CompactSand1967();
  c.soil.shear.cohesion = c.soil.shear.friction_angle = 0;
  EXPECT_THAT([&] { Towed(c); }, ThrowsMessage<InputError>(
                                     HasSubstr("cohesion or friction angle must be > 0, got 0")));
  EXPECT_EQ(DrivenAt(0.2, c).thrust, 0);
}

}  // namespace
}  // namespace softsoil
