// Against the sum over all pairs: off by less than 1e-2 of the peak stress in any volume, and by
// 1e-3 in root mean square.
#include <gtest/gtest.h>

#include "tests/terrain/wheel_on_ground.h"

namespace softsoil {
namespace {

constexpr double kNear = 1.25 * kDx;                        // [m]
constexpr double kFactors[] = {3, 3.3, 4, 4.5, 5, 5.7, 6};  // nu

std::vector<float> Gaussian(const StressSettings& settings, const StressCase& c) {
  std::vector<float> stress;
  MakeGaussianStress(settings, kDx)->VerticalStress(c.batch, c.load, &stress);
  return stress;
}

// As shares of the peak stress.
struct Errors {
  double largest, root_mean_square;
};

Errors ErrorsOf(const std::vector<float>& stress, const std::vector<float>& expected) {
  EXPECT_EQ(stress.size(), expected.size());
  double peak = 0, largest = 0, squares = 0;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const double error = std::abs(double(stress[i]) - expected[i]);
    peak = std::max(peak, std::abs(double(expected[i])));
    largest = error <= largest ? largest : error;  // a NaN stays
    squares += error * error;
  }
  EXPECT_GT(peak, 1e3);
  return {largest / peak, std::sqrt(squares / double(expected.size())) / peak};
}

void ExpectClose(const StressSettings& settings, const StressCase& c, const std::string& name) {
  const Errors errors = ErrorsOf(Gaussian(settings, c), Stress(settings, c.batch, c.load));
  ::testing::Test::RecordProperty("largest_error" + name, std::to_string(errors.largest));
  ::testing::Test::RecordProperty("rms_error" + name, std::to_string(errors.root_mean_square));
  EXPECT_LT(errors.largest, 1e-2) << name;
  EXPECT_LT(errors.root_mean_square, 1e-3) << name;
}

void ExpectCloseForAllFactors(const StressCase& c) {
  for (const double nu : kFactors) ExpectClose({{nu}, kNear, 2}, c, "_nu_" + std::to_string(nu));
}

TEST(GaussianStress, AgreesWithPairsOnFlatGround) {
  ExpectCloseForAllFactors(OneWheel(Flat, Driving));
}

TEST(GaussianStress, AgreesWithPairsInARut) { ExpectCloseForAllFactors(OneWheel(Rut, Driving)); }

TEST(GaussianStress, AgreesWithPairsInATrench) {
  ExpectCloseForAllFactors(OneWheel(Trench, Driving));
}

TEST(GaussianStress, AgreesWithPairsOnSlopes) {
  ExpectCloseForAllFactors(OneWheel(Slope, Driving));
  ExpectCloseForAllFactors(OneWheel(SlopeAcross, Driving));
}

TEST(GaussianStress, AgreesWithPairsForForcesWithoutOrder) {
  ExpectCloseForAllFactors(OneWheel(Flat, Rough));
  ExpectCloseForAllFactors(OneWheel(Rut, Rough));
}

TEST(GaussianStress, AgreesWithPairsForHorizontalForces) {
  ExpectCloseForAllFactors(OneWheel(Flat, PushingAside));
  ExpectCloseForAllFactors(OneWheel(SlopeAcross, PushingAside));
}

// Below its middle a whole circle of forces comes into the cone at once.
TEST(GaussianStress, AgreesWithPairsUnderALoadedCircle) {
  ExpectCloseForAllFactors(OneWheel(Flat, OfACircle));
}

TEST(GaussianStress, AgreesWithPairsForOneForce) {
  for (const Height& height : {Height(Flat), Height(Slope), Height(Rut)}) {
    StressCase c;
    AddForces({1, -2}, {0, 0}, height, Driving, &c);
    AddColumns({0, 0}, {12, 9}, height, &c);
    ExpectCloseForAllFactors(c);
  }
}

TEST(GaussianStress, AgreesWithPairsForOneColumn) {
  StressCase c;
  AddForces({0, 0}, {9, 10}, Flat, Driving, &c);
  AddColumns({4, 7}, {0, 0}, Flat, &c);
  ExpectCloseForAllFactors(c);
}

TEST(GaussianStress, AgreesWithPairsForAnyNumberOfVolumes) {
  for (const int volumes : {1, 2, 5, 70}) {
    StressCase c;
    AddForces({7, 7}, {3, 4}, Flat, Driving, &c);
    c.batch = Block({0, 0}, 14, kDx, volumes, kDx, 0);
    c.batch.surface_pressure.assign(c.batch.columns(), 80e3);
    ExpectCloseForAllFactors(c);
  }
}

TEST(GaussianStress, AgreesWithPairsWhereSoilsDifferBetweenColumns) {
  StressCase c = OneWheel(Rut, Driving);
  for (std::size_t i = 0; i < c.batch.columns(); ++i) c.batch.soil[i] = int(i * i / 7) % 4;
  ExpectClose({{3, 5.5, 4.2, 5.5}, kNear, 2}, c, "");
}

TEST(GaussianStress, AgreesWithPairsBelowSeveralWheels) {
  StressCase c;
  for (const GridNode wheel : {GridNode{0, 0}, {120, 4}, {3, 70}, {123, 66}}) {
    AddForces(wheel, {7, 6}, Rut, Driving, &c);
  }
  for (const GridNode wheel : {GridNode{0, 0}, {120, 4}, {3, 70}, {123, 66}}) {
    AddColumns(wheel, {14, 16}, Rut, &c);
  }
  ExpectCloseForAllFactors(c);
}

// As rectangle with all columns in it this would not fit into memory.
TEST(GaussianStress, AgreesWithPairsForWheelsKilometresApart) {
  StressCase c;
  for (const GridNode wheel : {GridNode{-40000, 40000}, {40000, -40000}}) {
    AddForces(wheel, {7, 6}, Flat, Driving, &c);
  }
  for (const GridNode wheel : {GridNode{-40000, 40000}, {40000, -40000}}) {
    AddColumns(wheel, {14, 16}, Flat, &c);
  }
  ExpectClose({{4.5}, kNear, 2}, c, "");
}

TEST(GaussianStress, AgreesWithPairsHighAboveTheOrigin) {
  const Height high = [](double x, double y) { return 300 + Slope(x, y); };
  ExpectClose({{4.5}, kNear, 2}, OneWheel(high, Driving), "");
}

// A wheel on a bank, and columns below it whose highest volumes lie deep under its forces.
TEST(GaussianStress, AgreesWithPairsFarAboveTheColumns) {
  const Height bank = [](double x, double) { return x < 0 ? 0.0 : -0.5; };
  ExpectCloseForAllFactors(OneWheel(bank, Pressing));
}

TEST(GaussianStress, HasTheNearFieldOfPairsToTheBit) {
  const StressCase c = OneWheel(Rut, Driving);
  StressCase marked = c;
  for (double& pressure : marked.batch.surface_pressure) pressure = 1e9;
  const StressSettings settings{{4.5}, kNear, 2};
  const std::vector<float> expected = Stress(settings, marked.batch, marked.load);
  const std::vector<float> stress = Gaussian(settings, marked);
  ASSERT_EQ(stress.size(), expected.size());
  int near = 0;
  for (std::size_t i = 0; i < stress.size(); ++i) {
    near += expected[i] == 1e9f;
    EXPECT_EQ(stress[i] == 1e9f, expected[i] == 1e9f) << i;
  }
  EXPECT_GT(near, 400);
}

TEST(GaussianStress, HasTheSameBitsOnAnyNumberOfThreads) {
  for (const Height& height : {Height(Flat), Height(Rut), Height(SlopeAcross)}) {
    const StressCase c = OneWheel(height, Rough);
    const std::vector<float> one = Gaussian({{5}, kNear, 1}, c);
    ASSERT_GT(*std::max_element(one.begin(), one.end()), 1e3);
    for (int threads : {2, 3, 8}) EXPECT_EQ(one, Gaussian({{5}, kNear, threads}, c)) << threads;
  }
}

TEST(GaussianStress, DoesNotDependOnTheOrderOfColumnsAndForces) {
  const StressCase c = OneWheel(Rut, Rough);
  StressCase reversed = c;
  std::reverse(reversed.load.begin(), reversed.load.end());
  const std::size_t columns = c.batch.columns(), volumes = c.batch.volumes;
  for (std::size_t to = 0; to < columns; ++to) {
    const std::size_t from = columns - 1 - to;
    reversed.batch.x[to] = c.batch.x[from];
    reversed.batch.y[to] = c.batch.y[from];
    reversed.batch.surface_pressure[to] = c.batch.surface_pressure[from];
    std::copy_n(&c.batch.z[from * volumes], volumes, &reversed.batch.z[to * volumes]);
  }
  const std::vector<float> stress = Gaussian({{5}, kNear, 2}, c);
  const std::vector<float> other = Gaussian({{5}, kNear, 2}, reversed);
  for (std::size_t to = 0; to < columns; ++to) {
    const auto first = stress.begin() + (columns - 1 - to) * volumes;
    ASSERT_TRUE(std::equal(first, first + volumes, other.begin() + to * volumes)) << to;
  }
}

TEST(GaussianStress, AddsUpForcesOnOneNode) {
  StressCase c = OneWheel(Flat, Driving);
  const std::vector<float> once = Gaussian({{5}, 1e-6, 1}, c);
  const SurfaceLoad load = c.load;
  c.load.insert(c.load.end(), load.begin(), load.end());
  const std::vector<float> twice = Gaussian({{5}, 1e-6, 1}, c);
  const float peak = *std::max_element(twice.begin(), twice.end());
  ASSERT_GT(peak, 1e3);
  for (std::size_t i = 0; i < once.size(); ++i) ASSERT_NEAR(twice[i], 2 * once[i], 1e-5 * peak);
}

TEST(GaussianStress, IsZeroWithoutLoad) {
  StressCase c;
  AddColumns({0, 0}, {3, 3}, Flat, &c);
  const std::vector<float> stress = Gaussian({{5}, kNear, 1}, c);
  EXPECT_EQ(stress, std::vector<float>(49 * 30, 0.0f));
}

TEST(GaussianStress, IsZeroAboveTheForces) {
  StressCase c;
  AddForces(
      {0, 0}, {2, 2}, [](double, double) { return -5; }, Driving, &c);
  AddColumns({0, 0}, {3, 3}, Flat, &c);
  EXPECT_EQ(Gaussian({{5}, kNear, 1}, c), std::vector<float>(49 * 30, 0.0f));
}

TEST(GaussianStress, OfNoColumnsIsEmpty) {
  StressCase c = OneWheel(Flat, Driving);
  c.batch = {};
  c.batch.volumes = 30;
  EXPECT_TRUE(Gaussian({{5}, kNear, 1}, c).empty());
}

// The errors that these tests bound tell another law.
TEST(GaussianStress, OfAnotherConcentrationFactorIsNotClose) {
  const StressCase c = OneWheel(Flat, Driving);
  const Errors errors =
      ErrorsOf(Gaussian({{4.8}, kNear, 1}, c), Stress({{5}, kNear, 1}, c.batch, c.load));
  EXPECT_GT(errors.largest, 1e-2);
  EXPECT_GT(errors.root_mean_square, 1e-3);
}

}  // namespace
}  // namespace softsoil
