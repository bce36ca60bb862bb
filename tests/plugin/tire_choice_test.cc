#include "plugin/tire_choice.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "contact/flat_plate.h"
#include "plugin/time_step.h"
#include "terrain/input_error.h"
#include "tests/plugin/one_wheel.h"

namespace softsoil {
namespace {

Wheel WheelWith(const std::string& geom) {
  OneWheel model;
  model.wheel_geom = geom;
  return FindWheels(Load(model.Mjcf()).get(), {}).at(0);
}

TEST(AutoTire, GivesByTwoPercentOfItsRadiusWhateverItsOutline) {
  for (const char* geom :
       {R"(type="cylinder" zaxis="0 1 0" size=".4 .1")", R"(type="sphere" size=".05")",
        R"(type="capsule" zaxis="0 1 0" size=".3 .001")",
        R"(type="capsule" zaxis="0 1 0" size=".1 .4")", R"(type="ellipsoid" size=".4 .15 .4")",
        R"(type="ellipsoid" size=".4 .5 .4")"}) {
    const Wheel wheel = WheelWith(geom);
    const Tire tire = AutoTire(wheel, 1000);
    const double load = FlatPlateLoad(tire, 0.02 * wheel.radius, wheel.radius / 100);
    EXPECT_NEAR(load, 1000, 1) << geom;
    EXPECT_EQ(tire.shape.radius, wheel.radius);
    EXPECT_GE(tire.shape.crown_radius, tire.shape.width / 2);
    EXPECT_GT(tire.damping, 0);
  }
}

TEST(AutoTire, IsRoundLikeItsGeom) {
  EXPECT_TRUE(std::isinf(
      AutoTire(WheelWith(R"(type="cylinder" zaxis="0 1 0" size=".4 .1")"), 1).shape.crown_radius));
  EXPECT_EQ(AutoTire(WheelWith(R"(type="sphere" size=".4")"), 1).shape.crown_radius, 0.4);
  EXPECT_NEAR(AutoTire(WheelWith(R"(type="ellipsoid" size=".4 .2 .4")"), 1).shape.crown_radius, 0.1,
              1e-12);
}

// What a setting of tires gives the wheel of that model.
Tire ChosenBy(const std::string& text) {
  const auto m = Load(OneWheel().Mjcf());
  Settings settings = SettingsOf(m.get());
  Override("tire=" + text, &settings);
  return ChooseTires(m.get(), FindWheels(m.get(), {}), settings).at(0);
}

TEST(ChooseTires, TakesAnInflationPressureWhereverATireIsNamed) {
  EXPECT_EQ(ChosenBy("18.4R38@85kPa").spring.root, 346900);
  EXPECT_NEAR(ChosenBy("auto,wheel=18.4R38@105kPa").spring.root, (346900 + 534500) / 2, 1e-6);
  EXPECT_THROW(ChosenBy("18.4R38@200kPa"), InputError);
}

TEST(StaticLoad, IsTheWheelsShareOfItsVehicle) {
  const Model m = Load(OneWheel{}.Mjcf());
  const auto wheels = FindWheels(m.get(), {});
  EXPECT_NEAR(StaticLoad(m.get(), wheels, wheels[0]), kOneWheelWeight, 1e-9);
}

// Whether x'' = -(k x + c x') / m stays bounded under MuJoCo's semi-implicit Euler.
bool StaysBounded(const Oscillator& o, double h) {
  double x = 1, v = 0;
  for (int i = 0; i < 10000 && std::abs(x) < 1e6; ++i) {
    v -= h * (o.stiffness * x + o.damping * v) / o.mass;
    x += h * v;
  }
  return std::abs(x) < 1e6;
}

TEST(LongestStep, IsWhereSemiImplicitEulerTurnsUnstable) {
  for (const Oscillator& o :
       {Oscillator{2, 1000, 0}, Oscillator{2, 1000, 20}, Oscillator{0.1, 50, 30}}) {
    const double longest = LongestStep(o);
    EXPECT_TRUE(StaysBounded(o, 0.99 * longest));
    EXPECT_FALSE(StaysBounded(o, 1.01 * longest));
  }
  EXPECT_NEAR(LongestStep({2, 1000, 0}), 2 * std::sqrt(2.0 / 1000), 1e-12);
}

TEST(LongestStep, HasNoBoundForAWheelThatIsHeldFast) {
  EXPECT_TRUE(std::isinf(LongestStep({std::numeric_limits<double>::infinity(), 1000, 10})));
}

TEST(LongestStep, IsShorterUnderAHeavierLoad) {
  const Model m = Load(OneWheel{}.Mjcf());
  const Wheel wheel = FindWheels(m.get(), {})[0];
  Soil soil{};
  soil.shear = {5000, 0.5, 0.01};
  const double soft = LongestStep(m.get(), wheel, AutoTire(wheel, 1000), soil, 1000);
  const double hard = LongestStep(m.get(), wheel, AutoTire(wheel, 10000), soil, 10000);
  EXPECT_LT(hard, soft);
  EXPECT_GT(hard, 1e-4);
  EXPECT_LT(soft, 1);
}

}  // namespace
}  // namespace softsoil
