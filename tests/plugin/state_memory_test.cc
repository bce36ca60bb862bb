// What copies and past states of the soil really take, as the allocator tells.
#include <gmock/gmock.h>

#include <string>

#include "tests/plugin/heap.h"
#include "tests/plugin/hmmwv.h"

namespace softsoil {
namespace {

using testing::AllOf;
using testing::Gt;
using testing::Lt;

double Heap(const Hmmwv& hmmwv) {
  hmmwv.WaitForSoil();
  return HeapBytes();
}

class SoilMemory : public testing::Test {
 protected:
  void SetUp() override {
    if (HeapBytes() == 0) GTEST_SKIP() << "the allocator does not tell";
  }
};

TEST_F(SoilMemory, OfACopyIsLessThanAHundredthOfGroundWith100mOfTracks) {
  const double none = HeapBytes();
  Hmmwv from(kSoils[1]), to(kSoils[1]);
  from.Step(100);
  DentTracks(from.ground(), 100, true);
  const double before = Heap(from), soil = before - none;
  ASSERT_GT(soil, 100e6);
  RequireSuccess(softsoil_copy(to.d(), from.d()));
  EXPECT_LT(HeapBytes() - before, 0.01 * soil);
}

// A wheel is on some tiles only.
TEST_F(SoilMemory, OfACopyGrowsByTheTilesUnderTheWheelsAsItGoesItsOwnWay) {
  Hmmwv from(kSoils[1]), to(kSoils[1]);
  from.Step(100);
  DentTracks(from.ground(), 100, true);
  const double before = Heap(from);
  mj_copyData(to.d(), from.m(), from.d());
  RequireSuccess(softsoil_copy(to.d(), from.d()));
  to.Step(30);
  EXPECT_LT(Heap(to) - before, 10e6);
}

double HeapOf(const std::string& settings, int nuserdata) {
  const double before = HeapBytes();
  Hmmwv hmmwv(settings, nuserdata);
  hmmwv.Step(400);
  return Heap(hmmwv) - before;
}

TEST_F(SoilMemory, OfAHistoryIsWhatItMayTake) {
  for (const std::string soil : kSoils) {
    const double history = HeapOf(soil + " history=20", kMarkSize) - HeapOf(soil, 0);
    EXPECT_THAT(history / 20e6, AllOf(Gt(1 / 1.5), Lt(1.5))) << soil;
  }
}

}  // namespace
}  // namespace softsoil
