// softsoil_visit_contacts(): the contact patch of a wheel through the C API.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "tests/plugin/simulation.h"

namespace softsoil {
namespace {

std::vector<softsoilContact> Contacts(const Simulation& sim) {
  std::vector<softsoilContact> contacts;
  const auto append = [](void* user, const softsoilContact* contact) {
    static_cast<std::vector<softsoilContact>*>(user)->push_back(*contact);
  };
  EXPECT_EQ(softsoil_visit_contacts(sim.d.get(), 0, append, &contacts), 0) << softsoil_error();
  return contacts;
}

TEST(VisitContacts, AddUpToWhatTheWheelReports) {
  Simulation sim{OneWheel{}};
  sim.d->qvel[0] = 1;
  sim.Run(0.5);
  const softsoilWheel wheel = sim.Wheel();
  double force[3] = {}, area = 0, deepest = 0, highest_pressure = 0, furthest_left = 0;
  for (const softsoilContact& c : Contacts(sim)) {
    for (int k = 0; k < 3; ++k) force[k] += c.normal_force[k] + c.shear_force[k];
    EXPECT_NEAR(mju_norm3(c.normal_force), c.pressure * c.area, 1e-9 * wheel.load);
    EXPECT_NEAR(mju_norm3(c.shear_force), std::hypot(c.shear, c.shear_across) * c.area,
                1e-9 * wheel.load);
    EXPECT_NEAR(c.position[0] - wheel.centre[0],
                std::tan(c.angle) * (wheel.centre[2] - c.position[2]), 1e-9);
    EXPECT_NEAR(c.position[1], c.lateral, 1e-9);
    area += c.area;
    deepest = std::max(deepest, c.depth);
    highest_pressure = std::max(highest_pressure, c.pressure);
    furthest_left = std::max(furthest_left, c.lateral);
  }
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(force[k], wheel.force[k], 1e-9 * wheel.load);
  EXPECT_NEAR(area, wheel.contact_area, 1e-9);
  EXPECT_EQ(deepest, wheel.sinkage);
  EXPECT_EQ(highest_pressure, wheel.peak_pressure);
  EXPECT_NEAR(furthest_left, 0.1, 0.025);
}

TEST(VisitContacts, ReachFurtherAheadThanBehindOfAWheelThatRolls) {
  Simulation sim{OneWheel{}};
  sim.Run(1, [&sim] { sim.d->qvel[0] = 1; });
  double ahead = 0, behind = 0;
  for (const softsoilContact& c : Contacts(sim)) {
    ahead = std::max(ahead, c.angle);
    behind = std::min(behind, c.angle);
  }
  EXPECT_GT(ahead, -1.5 * behind);
  EXPECT_LT(behind, 0);
}

TEST(VisitContacts, VisitNothingBeforeTheFirstStepAndInTheAir) {
  Simulation sim{OneWheel{}};
  EXPECT_TRUE(Contacts(sim).empty());
  sim.d->qpos[1] = 1;
  sim.Run(0.01);
  EXPECT_TRUE(Contacts(sim).empty());
}

TEST(VisitContacts, RefuseBadArguments) {
  const Simulation sim{OneWheel{}};
  const auto nothing = [](void*, const softsoilContact*) {};
  EXPECT_EQ(softsoil_visit_contacts(nullptr, 0, nothing, nullptr), -1);
  EXPECT_STREQ(softsoil_error(), "mjData must not be NULL");
  EXPECT_EQ(softsoil_visit_contacts(sim.d.get(), 0, nullptr, nullptr), -1);
  EXPECT_STREQ(softsoil_error(), "visit must not be NULL");
  for (int wheel : {-1, 1}) {
    EXPECT_EQ(softsoil_visit_contacts(sim.d.get(), wheel, nothing, nullptr), -1);
    EXPECT_EQ(softsoil_error(), "wheel must be 0 to 0, got " + std::to_string(wheel));
  }
  const Data other = MakeData(sim.m);
  EXPECT_EQ(softsoil_visit_contacts(other.get(), 0, nothing, nullptr), -1);
  EXPECT_STREQ(softsoil_error(), "this mjData has no soil: call softsoil_attach() first");
}

}  // namespace
}  // namespace softsoil
