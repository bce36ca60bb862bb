#include "plugin/soil_regions.h"

#include <gmock/gmock.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>

#include "plugin/soil_plan.h"
#include "terrain/constants.h"
#include "terrain/input_error.h"
#include "tests/plugin/simulation.h"

namespace softsoil {
namespace {

using testing::HasSubstr;

const std::string kPatch = R"(<site name="patch" type="box" size="2 1 .1" pos="3 0 0"/>)";

std::string Field(const std::string& sites, const std::string& plane = "") {
  return World(R"(<geom name="field" type="plane" size="9 9 1" )" + plane + "/>" + sites +
               R"(<body name="cart"><joint type="slide"/><geom size="1"/>
                    <site name="mounted" type="box" size="1 1 1"/></body>)");
}

SoilMap SoilsOf(const std::string& mjcf, const std::string& regions) {
  const Model m = Load(mjcf);
  Settings settings;
  Override("soil=tilled_yolo_loam regions=" + regions, &settings);
  return ChooseSoils(m.get(), FindGroundPlane(m.get(), ""), settings);
}

std::string Refusal(const std::string& mjcf, const std::string& regions) {
  try {
    SoilsOf(mjcf, regions);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(SoilRegions, LieWhereTheBoxesOfTheirSitesCutTheGround) {
  const SoilMap soils =
      SoilsOf(Field(kPatch + R"(<site name="strip" type="box" size="5 .2 1" euler="0 0 45"/>)"),
              "patch=lete_sand,strip=firm_yolo_loam");
  EXPECT_EQ(soils.At(4.9, -0.9).name, "lete_sand");
  EXPECT_EQ(soils.At(5.1, 0).name, "tilled_yolo_loam");
  EXPECT_EQ(soils.At(3, 3).name, "firm_yolo_loam");
  EXPECT_EQ(soils.At(3, -3).name, "tilled_yolo_loam");
  EXPECT_EQ(soils.At(1.05, 0.95).name, "firm_yolo_loam") << "the later one";
}

// On a slope a box is shorter as seen from above, by the cosine.
TEST(SoilRegions, FollowAnInclinedPlane) {
  const SoilMap soils = SoilsOf(Field(R"(<site name="patch" type="box" size="2 1 .3" euler="0 -30 0"
                             pos="-.1 0 .173205"/>)",
                                      "euler=\"0 -30 0\""),
                                "patch=lete_sand");
  const double reach = 2 * std::cos(kPi / 6);
  for (const double way : {-1.0, 1.0}) {
    EXPECT_EQ(soils.At(way * (reach - 0.001), 0.99).name, "lete_sand");
    EXPECT_EQ(soils.At(way * (reach + 0.001), 0).name, "tilled_yolo_loam");
  }
}

TEST(SoilRegions, AreRefusedWithNameRuleAndValue) {
  struct Case {
    std::string site, regions, message;
  };
  for (const Case& c : std::vector<Case>{
           {kPatch, "path=lete_sand", "softsoil_regions: the model has no site \"path\""},
           {kPatch, "patch=quicksand",
            "softsoil_regions: site \"patch\": unknown soil \"quicksand\"; known are: "},
           {R"(<site name="patch" type="sphere" size="1"/>)", "patch=lete_sand",
            "site \"patch\" must be of type box, got sphere"},
           {"", "mounted=lete_sand",
            "site \"mounted\" must belong to the world body, got body \"cart\""},
           {R"(<site name="patch" type="box" size="1 1 .1" pos="0 0 .2"/>)", "patch=lete_sand",
            "site \"patch\" must cut geom \"field\": its centre at most its half height 0.1 m "
            "away, got 0.2"},
           {R"(<site name="patch" type="box" size="1 1 1" euler="20 0 0"/>)", "patch=lete_sand",
            "site \"patch\" must stand upright on geom \"field\": its z axis at most 0.1 degrees "
            "from the normal, got 20"},
       }) {
    EXPECT_THAT(Refusal(Field(c.site), c.regions), HasSubstr(c.message)) << c.regions;
  }
}

OneWheel OnTwoSoils(const std::string& soil) {
  OneWheel model;
  model.custom += R"(<text name="softsoil_regions" data="patch=)" + soil + R"("/>
                     <numeric name="softsoil_grid_spacing" data="0.05"/>)";
  model.others = "<worldbody>" + kPatch + "</worldbody>";
  return model;
}

TEST(SoilRegions, LetAWheelSinkAsInTheirSoilAlone) {
  const auto sinkage_at = [](double x, const char* settings) {
    Simulation sim(OnTwoSoils("firm_yolo_loam"), settings);
    sim.d->qpos[0] = x;
    sim.Run(0.3);
    return sim.Wheel().sinkage;
  };
  const double on_patch = sinkage_at(3, "");
  EXPECT_EQ(on_patch, sinkage_at(3, "soil=firm_yolo_loam regions=none"));
  EXPECT_GT(sinkage_at(0, ""), 1.5 * on_patch);
}

TEST(SoilRegions, BelongToAState) {
  const std::string path = testing::TempDir() + "softsoil_regions_" + std::to_string(getpid());
  const Simulation sim(OnTwoSoils("firm_yolo_loam")), alike(OnTwoSoils("firm_yolo_loam"));
  const Simulation other(OnTwoSoils("lete_sand")), none(OnTwoSoils("lete_sand"), "regions=none");
  ASSERT_EQ(softsoil_save(sim.d.get(), path.c_str()), 0) << softsoil_error();
  EXPECT_EQ(softsoil_load(alike.d.get(), path.c_str()), 0) << softsoil_error();
  EXPECT_EQ(softsoil_load(other.d.get(), path.c_str()), -1);
  EXPECT_THAT(softsoil_error(), HasSubstr("soil is lete_sand here, there firm_yolo_loam"));
  EXPECT_EQ(softsoil_load(none.d.get(), path.c_str()), -1);
  EXPECT_THAT(softsoil_error(), HasSubstr("centre of region 1 is none here, there 3"));
  std::remove(path.c_str());
}

}  // namespace
}  // namespace softsoil
