// Ground that springs back below a tire.
#include <gtest/gtest.h>

#include "tests/contact/soil_bin.h"

namespace softsoil {
namespace {

Soil SpringingLoam() {
  Soil soil = TilledLoam();
  soil.unloading = {1e6, 100e6};
  return soil;
}

TEST(SpringBack, LeavesAShallowerRutThanTheWheelSinks) {
  SoilBinSettings settings;
  settings.soil = SpringingLoam();
  SoilBin bin(settings);
  const WheelReport springing = bin.Measure(0.2);
  const WheelReport rigid = SoilBin(SoilBinSettings{}).Measure(0.2);
  EXPECT_LT(springing.rut_depth, 0.9 * springing.sinkage);
  EXPECT_GT(springing.rut_depth, 0.1 * springing.sinkage);
  EXPECT_NEAR(rigid.rut_depth / rigid.sinkage, 1, 0.05);
}

// What springs back behind the wheel pushes it forward.
TEST(SpringBack, EasesTheMotion) {
  SoilBinSettings settings;
  settings.soil = SpringingLoam();
  const WheelReport springing = SoilBin(settings).Measure(0.2);
  const WheelReport rigid = SoilBin(SoilBinSettings{}).Measure(0.2);
  EXPECT_LT(springing.motion_resistance, 0.95 * rigid.motion_resistance);
  EXPECT_GT(springing.motion_resistance, 0);
}

TEST(SpringBack, StandsStillUnderAWheelAtRest) {
  SoilBinSettings settings;
  settings.soil = SpringingLoam();
  SoilBin bin(settings);
  bin.Drive(1.5, 0, 0);
  const double before = bin.pose().centre_w.z();
  const WheelReport rest = bin.Drive(0.5, 0, 0);
  EXPECT_NEAR(bin.pose().centre_w.z(), before, 1e-4);
  EXPECT_NEAR(rest.load / settings.load, 1, 0.01);
}

}  // namespace
}  // namespace softsoil
