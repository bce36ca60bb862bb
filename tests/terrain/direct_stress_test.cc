#include <gtest/gtest.h>

#include "tests/terrain/stress_case.h"

namespace softsoil {
namespace {

constexpr double kDx = 0.025;          // [m]
constexpr double kNoNearField = 1e-6;  // [m]

// Largest error as a share of the peak stress. A volume on the very edge of a cone may fall on
// either side of it in float; the columns stand off the nodes so that none does.
double LargestError(double nu, const ColumnBatch& batch, const SurfaceLoad& load) {
  const std::vector<float> stress = Stress({{nu}, kNoNearField, 1}, batch, load);
  const std::vector<double> expected = OracleStress(nu, batch, load);
  EXPECT_EQ(stress.size(), expected.size());
  double peak = 0, error = 0;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    peak = std::max(peak, std::abs(expected[i]));
    error = std::max(error, std::abs(stress[i] - expected[i]));
  }
  EXPECT_GT(peak, 1e3);
  return error / peak;
}

void MoveOffTheNodes(ColumnBatch* batch) {
  for (std::size_t i = 0; i < batch->columns(); ++i) {
    batch->x[i] += 0.0031;
    batch->y[i] -= 0.0017;
  }
}

ColumnBatch Below(GridNode corner, double top) {
  ColumnBatch batch = Block(corner, 14, kDx, 30, kDx, top);
  MoveOffTheNodes(&batch);
  return batch;
}

TEST(DirectStress, AgreesWithTheOracleForRealConcentrationFactors) {
  for (double nu : {3.0, 3.3, 4.0, 4.5, 5.0, 5.7, 6.0}) {
    const double error = LargestError(nu, Below({-3, -3}, 0), RandomLoad({0, 0}, 8, kDx, 0, 1));
    RecordProperty("error_nu_" + std::to_string(nu), std::to_string(error * 1e6) + "e-6");
    EXPECT_LT(error, 1e-5) << nu;
  }
}

TEST(DirectStress, AgreesWithTheOracleForForcesAtDifferentHeights) {
  const double error = LargestError(4.5, Below({-3, -3}, 0.05), RandomLoad({0, 0}, 8, kDx, 0.2, 2));
  RecordProperty("error", std::to_string(error * 1e6) + "e-6");
  EXPECT_LT(error, 1e-5);
}

TEST(DirectStress, AgreesWithTheOracleAKilometreFromTheOrigin) {
  const GridNode far{40000, -40000};
  ColumnBatch batch = Below({far.i - 3, far.j - 3}, 300);
  SurfaceLoad load = RandomLoad(far, 8, kDx, 0.02, 3);
  for (NodeForce& f : load) f.z += 300;
  const double error = LargestError(5, batch, load);
  RecordProperty("error", std::to_string(error * 1e6) + "e-6");
  EXPECT_LT(error, 1e-5);
}

TEST(DirectStress, AgreesWithTheOracleForAnyNumberOfVolumes) {
  for (int volumes : {1, 2, 15, 16, 17, 33}) {
    ColumnBatch batch = Block({-3, -3}, 14, kDx, volumes, kDx, 0);
    MoveOffTheNodes(&batch);
    EXPECT_LT(LargestError(5, batch, RandomLoad({0, 0}, 8, kDx, 0, 4)), 1e-5) << volumes;
  }
}

TEST(DirectStress, HasTheSameBitsOnAnyNumberOfThreads) {
  const ColumnBatch batch = Block({-3, -3}, 14, kDx, 30, kDx, 0);
  const SurfaceLoad load = RandomLoad({0, 0}, 8, kDx, 0.02, 5);
  const std::vector<float> one = Stress({{5}, 1.25 * kDx, 1}, batch, load);
  ASSERT_GT(*std::max_element(one.begin(), one.end()), 1e3);
  EXPECT_EQ(one, Stress({{5}, 1.25 * kDx, 2}, batch, load));
  EXPECT_EQ(one, Stress({{5}, 1.25 * kDx, 4}, batch, load));
}

TEST(DirectStress, OfAColumnDoesNotDependOnTheOthersAskedFor) {
  const SurfaceLoad load = RandomLoad({0, 0}, 8, kDx, 0.02, 6);
  const std::vector<float> all =
      Stress({{5}, 1.25 * kDx, 1}, Block({-3, -3}, 14, kDx, 30, kDx, 0), load);
  const std::vector<float> one =
      Stress({{5}, 1.25 * kDx, 1}, Block({-3, -3}, 1, kDx, 30, kDx, 0), load);
  EXPECT_EQ(one, std::vector<float>(all.begin(), all.begin() + 30));
}

TEST(DirectStress, IsSymmetricAboutAForce) {
  const SurfaceLoad load{ForceAt({0, 0}, kDx, 0, {0, 0, -1e3})};
  const std::vector<float> stress =
      Stress({{5}, kNoNearField, 1}, Block({-4, -4}, 9, kDx, 20, kDx, 0), load);
  const auto at = [&](int i, int j, int k) { return stress[((i + 4) * 9 + j + 4) * 20 + k]; };
  EXPECT_GT(at(3, 1, 19), 0);
  for (int k = 0; k < 20; ++k) {
    EXPECT_EQ(at(3, 1, k), at(-3, 1, k));
    EXPECT_EQ(at(3, 1, k), at(1, -3, k));
  }
}

TEST(DirectStress, OfALoadIsTheSumOfItsParts) {
  const ColumnBatch batch = Block({-3, -3}, 14, kDx, 30, kDx, 0);
  const SurfaceLoad a = RandomLoad({0, 0}, 4, kDx, 0.02, 7),
                    b = RandomLoad({4, 2}, 4, kDx, 0.02, 8);
  SurfaceLoad both = a;
  both.insert(both.end(), b.begin(), b.end());
  const StressSettings settings{{5}, kNoNearField, 1};
  const std::vector<float> sum = Stress(settings, batch, both), of_a = Stress(settings, batch, a),
                           of_b = Stress(settings, batch, b);
  const float peak = *std::max_element(sum.begin(), sum.end());
  ASSERT_GT(peak, 1e3);
  for (std::size_t i = 0; i < sum.size(); ++i) EXPECT_NEAR(sum[i], of_a[i] + of_b[i], 1e-5 * peak);
}

TEST(DirectStress, IsZeroWithoutLoad) {
  for (float stress : Stress({{5}, 0.03, 1}, Block({0, 0}, 3, kDx, 30, kDx, 0), {}))
    EXPECT_EQ(stress, 0);
}

TEST(DirectStress, OfNoColumnsIsEmpty) {
  EXPECT_TRUE(
      Stress({{5}, 0.03, 1}, Block({0, 0}, 0, kDx, 30, kDx, 0), RandomLoad({0, 0}, 2, kDx, 0, 9))
          .empty());
}

TEST(DirectStress, IsNotFeltAboveAForce) {
  const SurfaceLoad load{ForceAt({0, 0}, kDx, -0.1, {500, 0, -1e3})};
  const std::vector<float> stress = Stress({{5}, 0.03, 1}, Block({0, 0}, 1, kDx, 8, kDx, 0), load);
  for (int k = 0; k < 4; ++k) EXPECT_EQ(stress[k], 0) << k;
  EXPECT_GT(stress[7], 0);
}

TEST(DirectStress, IsNotFeltOutsideTheCone) {
  const SurfaceLoad load{ForceAt({0, 0}, kDx, 0, {0, 0, -1e3})};
  const std::vector<float> stress =
      Stress({{5}, kNoNearField, 1}, Block({8, 0}, 1, kDx, 8, kDx, 0), load);
  for (int k = 0; k < 8; ++k) {
    const bool inside = 0.2 * 0.2 <= 6 * std::pow((k + 0.5) * kDx, 2);
    EXPECT_EQ(stress[k] > 0, inside) << k;
  }
}

}  // namespace
}  // namespace softsoil
