// Columns whose initial density depends on the depth.
#include <gtest/gtest.h>

#include "tests/terrain/pressed_ground.h"

namespace softsoil {
namespace {

constexpr ColumnSettings kGrid{0.05, 0.05, 24};
const Circle kPlate{{0, 0}, 0.2, 250e3};

Columns LayeredColumns(const std::vector<DensityLayer>& layers) {
  Soil soil = LooseSoil();
  soil.layers = layers;
  return Columns(soil, kGrid, FlatGround,
                 MakeDirectStress({{soil.concentration_factor}, 1.25 * kGrid.spacing, 1}));
}

double SinkageInTheMiddle(const std::vector<DensityLayer>& layers) {
  Columns columns = LayeredColumns(layers);
  double sinkage = 0;
  for (int i = 0; i < 20; ++i) {
    const PeriodResult result = columns.Advance(LoadOf(kPlate, kGrid.spacing), 0.01);
    for (const NodeSinkage& s : result.compaction) {
      if (s.node.i == 0 && s.node.j == 0) sinkage = s.sinkage;
    }
  }
  return sinkage;
}

TEST(Layers, StartEveryVolumeAtTheDensityOfItsDepth) {
  Columns columns = LayeredColumns({{0.2, 1300}, {0.5, 1500}});
  columns.Advance(LoadOf(kPlate, kGrid.spacing), 0.01);
  const std::vector<double> densities = columns.Densities({12, 0});  // beside the plate
  ASSERT_EQ(densities.size(), 24u);
  EXPECT_EQ(densities[3], 1200);
  EXPECT_EQ(densities[4], 1300);
  EXPECT_EQ(densities[9], 1300);
  EXPECT_EQ(densities[10], 1500);
  EXPECT_EQ(densities[23], 1500);
}

TEST(Layers, OfTheSameDensityChangeNothing) {
  EXPECT_EQ(SinkageInTheMiddle({}), SinkageInTheMiddle({{0.1, 1200}, {0.3, 1200}}));
}

TEST(Layers, ThatAreDenserBelowKeepThePlateUp) {
  const double uniform = SinkageInTheMiddle({}), ploughed = SinkageInTheMiddle({{0.15, 1500}});
  EXPECT_LT(ploughed, 0.8 * uniform);
  EXPECT_GT(ploughed, 0.1 * uniform);
}

// A weak layer below a strong crust yields although the crust does not.
TEST(Layers, ThatAreWeakYieldBelowACrust) {
  Soil soil = LooseSoil();
  soil.compaction.initial_density = 1600;
  soil.layers = {{0.1, 1150}};
  Columns columns(soil, kGrid, FlatGround,
                  MakeDirectStress({{soil.concentration_factor}, 1.25 * kGrid.spacing, 1}));
  for (int i = 0; i < 10; ++i) columns.Advance(LoadOf(kPlate, kGrid.spacing), 0.01);
  const std::vector<double> densities = columns.Densities({0, 0});
  EXPECT_EQ(densities[0], 1600);
  EXPECT_GT(densities[3], 1160);
}

}  // namespace
}  // namespace softsoil
