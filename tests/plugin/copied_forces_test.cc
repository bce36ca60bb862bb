// The soil's share of xfrc_applied in copies of a mjData: there once, beside the host's part.
#include <gtest/gtest.h>

#include <ostream>
#include <vector>

#include "tests/plugin/compacting_wheel.h"

namespace softsoil {
namespace {

// Makes dst a copy of a, with its soil.
using Way = void (*)(const Simulation& a, mjData* dst);

void ByMark(const Simulation& a, mjData* dst) { mj_copyData(dst, a.m.get(), a.d.get()); }
void SoilLast(const Simulation& a, mjData* dst) {
  mj_copyData(dst, a.m.get(), a.d.get());
  ASSERT_EQ(softsoil_copy(dst, a.d.get()), 0) << softsoil_error();
}
void SoilFirst(const Simulation& a, mjData* dst) {
  ASSERT_EQ(softsoil_copy(dst, a.d.get()), 0) << softsoil_error();
  mj_copyData(dst, a.m.get(), a.d.get());
}
void AttachedAfterwards(const Simulation& a, mjData* dst) {
  mj_copyData(dst, a.m.get(), a.d.get());
  ASSERT_EQ(softsoil_attach(a.m.get(), dst, nullptr), 0) << softsoil_error();
  ASSERT_EQ(softsoil_copy(dst, a.d.get()), 0) << softsoil_error();
}

struct Case {
  const char* name;
  Way copy;
  int nuserdata;
};

void PrintTo(const Case& copied, std::ostream* out) { *out << copied.name; }

class CopiedForces : public testing::TestWithParam<Case> {
 protected:
  CopiedForces() : a_(CompactingWheel(GetParam().nuserdata)) { a_.d->qvel[0] = 1; }

  void PushWheel() {
    a_.Row()[0] = 200;
    a_.Row()[4] = -30;
  }
  // A copy into a mjData with soil of its own, and into one without.
  void ExpectSameForces() {
    Simulation with_soil(CompactingWheel(GetParam().nuserdata));
    with_soil.Row()[0] = 50;
    Step(with_soil, 7);
    const Data bare = MakeData(a_.m);
    std::vector<mjData*> copies = {with_soil.d.get(), bare.get()};
    for (mjData* copy : copies) GetParam().copy(a_, copy);
    const Moment now = After(0, a_), later = After(20, a_);
    for (mjData* copy : copies) {
      EXPECT_EQ(After(0, a_.m.get(), copy).forces, now.forces);
      EXPECT_TRUE(After(20, a_.m.get(), copy) == later);
    }
  }
  Simulation a_;
};
INSTANTIATE_TEST_SUITE_P(Copied, CopiedForces,
                         testing::Values(Case{"ByMark", ByMark, 2}, Case{"SoilLast", SoilLast, 0},
                                         Case{"SoilFirst", SoilFirst, 0},
                                         Case{"AttachedAfterwards", AttachedAfterwards, 0},
                                         Case{"SoilLastMarked", SoilLast, 2},
                                         Case{"SoilFirstMarked", SoilFirst, 2}),
                         [](const auto& info) { return info.param.name; });

TEST_P(CopiedForces, AreTheSameWithoutAForceOfTheHost) {
  Step(a_, 40);
  ASSERT_GT(a_.Row()[2], 100) << "there is a force to double";
  ExpectSameForces();
}

TEST_P(CopiedForces, AreTheSameBesideALastingForceOfTheHost) {
  PushWheel();
  Step(a_, 40);
  ExpectSameForces();
}

TEST_P(CopiedForces, AreTheSameIfTheHostPushesBetweenStepAndCopy) {
  Step(a_, 40);
  PushWheel();
  ExpectSameForces();
}

TEST_P(CopiedForces, AreTheSameInAHostThatClears) {
  Step(a_, 40);
  mju_zero(a_.d->xfrc_applied, 6 * a_.m->nbody);
  ExpectSameForces();
}

TEST_P(CopiedForces, AreTheSameDirectlyAfterFiniteDifferences) {
  PushWheel();
  Step(a_, 40);
  const double time = a_.d->time;
  std::vector<mjtNum> a(4 * a_.m->nv * a_.m->nv);
  mjd_transitionFD(a_.m.get(), a_.d.get(), 1e-6, 1, a.data(), nullptr, nullptr, nullptr);
  a_.d->time = time;
  ExpectSameForces();
}

TEST_P(CopiedForces, LeaveTheHostsPartWhenTheSoilIsTakenAway) {
  PushWheel();
  Step(a_, 40);
  const Data bare = MakeData(a_.m);
  GetParam().copy(a_, bare.get());
  Step(a_.m.get(), bare.get(), 1);
  ASSERT_EQ(softsoil_detach(a_.m.get(), bare.get()), 0) << softsoil_error();
  const double* row = bare->xfrc_applied + 6 * a_.WheelBody();
  const std::vector<double> hosts = {200, 0, 0, 0, -30, 0};
  EXPECT_EQ(std::vector<double>(row, row + 6), hosts);
}

TEST_P(CopiedForces, AreTakenOutOfACopyThatHasNotStepped) {
  PushWheel();
  Step(a_, 40);
  const Data bare = MakeData(a_.m);
  GetParam().copy(a_, bare.get());
  if (GetParam().copy == ByMark) mj_forward(a_.m.get(), bare.get());  // until then it has no soil
  ASSERT_EQ(softsoil_detach(a_.m.get(), bare.get()), 0) << softsoil_error();
  const double* row = bare->xfrc_applied + 6 * a_.WheelBody();
  const std::vector<double> hosts = {200, 0, 0, 0, -30, 0};
  EXPECT_EQ(std::vector<double>(row, row + 6), hosts);
}

}  // namespace
}  // namespace softsoil
