#include "plugin/settings.h"

#include <gmock/gmock.h>

#include "terrain/input_error.h"
#include "tests/plugin/mjcf.h"

namespace softsoil {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

Settings FromModel(const std::string& custom) {
  const std::string wheel =
      R"(<body name="w"><joint axis="0 1 0"/><geom name="g" size="1"/></body>)";
  return SettingsOf(Load(World(wheel, "<custom>" + custom + "</custom>")).get());
}

Settings FromText(const std::string& text) {
  Settings settings;
  Override(text, &settings);
  return settings;
}

template <class Read>
std::string Refusal(const Read& read, const std::string& input) {
  try {
    read(input);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

std::string Numeric(const std::string& name, const std::string& data) {
  return "<numeric name=\"softsoil_" + name + "\" data=\"" + data + "\"/>";
}
std::string Text(const std::string& name, const std::string& data) {
  return "<text name=\"softsoil_" + name + "\" data=\"" + data + "\"/>";
}

TEST(Settings, AreAllReadFromAModel) {
  const Settings s = FromModel(
      Text("soil", "mud") + Text("tire", "slick w=lugs") + Text("ground", "field") +
      Text("bumps", "0.05, 0.8, 7") + Text("mode", "compaction") + Text("rigid_contact", "remove") +
      Text("soil_file", " a.xml,\n my b.xml ") + Text("tire_file", "c.xml") +
      Numeric("grid_spacing", "0.05") + Numeric("volume_height", "0.03") +
      Numeric("volumes", "20") + Numeric("clock", "0.02") + Numeric("sync", "1") +
      Numeric("threads", "3") + Text("stress", "gaussian") +
      R"(<tuple name="softsoil_wheels"><element objtype="body" objname="w"/></tuple>)");
  EXPECT_EQ(s.soil, "mud");
  EXPECT_EQ(s.tires.of_all, "slick");
  EXPECT_EQ(s.tires.of_body.at("w"), "lugs");
  EXPECT_EQ(s.ground, "field");
  EXPECT_EQ(s.bumps.height, 0.05);
  EXPECT_EQ(s.bumps.spacing, 0.8);
  EXPECT_EQ(s.bumps.seed, 7u);
  EXPECT_EQ(s.terrain.mode, SurfaceMode::kCompaction);
  EXPECT_TRUE(s.remove_rigid_contact);
  EXPECT_THAT(s.soil_files, ElementsAre("a.xml", "my b.xml"));
  EXPECT_THAT(s.tire_files, ElementsAre("c.xml"));
  EXPECT_EQ(s.terrain.grid_spacing, 0.05);
  EXPECT_EQ(s.terrain.volume_height, 0.03);
  EXPECT_EQ(s.terrain.volumes, 20);
  EXPECT_EQ(s.terrain.soil_clock, 0.02);
  EXPECT_TRUE(s.terrain.sync);
  EXPECT_EQ(s.terrain.threads, 3);
  EXPECT_EQ(s.terrain.stress, StressBackend::kGaussian);
  EXPECT_THAT(s.wheels, ElementsAre("w"));
}

TEST(Settings, NeedNothingFromAModelThatWantsNoSoil) {
  const Settings s = FromModel("<numeric name=\"other\" data=\"1 2\"/>");
  EXPECT_EQ(s.soil, "");
  EXPECT_EQ(s.tires.of_all, "auto");
  EXPECT_EQ(s.bumps.height, 0);
  EXPECT_EQ(s.terrain.soil_clock, 0.01);
  EXPECT_EQ(s.terrain.volumes, 30);
  EXPECT_GE(s.terrain.threads, 1);
}

TEST(Settings, AreOverriddenByAText) {
  const Settings s = FromText("soil=mud clock=0.005;sync=1 mode=flow wheels=a,b tire=x,a=y");
  EXPECT_EQ(s.soil, "mud");
  EXPECT_EQ(s.terrain.soil_clock, 0.005);
  EXPECT_TRUE(s.terrain.sync);
  EXPECT_THAT(s.wheels, ElementsAre("a", "b"));
  EXPECT_EQ(s.tires.of_all, "x");
  EXPECT_EQ(s.tires.of_body.at("a"), "y");
}

TEST(Settings, OfEveryKeyHaveTheDefaultThatTheTableTells) {
  const Settings defaults;
  for (const Setting& setting : SettingTable()) {
    if (setting.kind != SettingKind::kNumber && setting.kind != SettingKind::kWholeNumber) continue;
    if (std::string(setting.name) == "threads") continue;
    Settings set;
    SettingValue value;
    value.number = std::stod(setting.fallback);
    setting.set(set, value);
    EXPECT_EQ(set.terrain.grid_spacing, defaults.terrain.grid_spacing) << setting.name;
    EXPECT_EQ(set.terrain.volume_height, defaults.terrain.volume_height) << setting.name;
    EXPECT_EQ(set.terrain.volumes, defaults.terrain.volumes) << setting.name;
    EXPECT_EQ(set.terrain.soil_clock, defaults.terrain.soil_clock) << setting.name;
    EXPECT_EQ(set.terrain.sync, defaults.terrain.sync) << setting.name;
  }
}

TEST(Settings, MayHaveRegionsOfOtherSoilsOrNone) {
  Settings s = FromText("regions=road=clay,ditch=mud");
  ASSERT_EQ(s.regions.size(), 2u);
  EXPECT_EQ(s.regions[0].site, "road");
  EXPECT_EQ(s.regions[1].soil, "mud");
  Override("regions=none", &s);
  EXPECT_TRUE(s.regions.empty());
}

TEST(Settings, MayHaveNoShapesNorFiles) {
  Settings s;
  Override("shapes=belly soil_file=a.xml tire_file=b.xml", &s);
  EXPECT_EQ(s.shapes.size() + s.soil_files.size() + s.tire_files.size(), 3u);
  Override("shapes=none soil_file=none tire_file=none", &s);
  EXPECT_EQ(s.shapes.size() + s.soil_files.size() + s.tire_files.size(), 0u);
}

TEST(Settings, MayHaveBumpsWithoutASeedOrNone) {
  const Settings s = FromText("bumps=0.1,2");
  EXPECT_EQ(s.bumps.height, 0.1);
  EXPECT_EQ(s.bumps.spacing, 2);
  EXPECT_EQ(s.bumps.seed, 0u);
  EXPECT_EQ(FromText("bumps=0.1,2,999999").bumps.seed, 999999u);
  Settings overridden = s;
  Override("bumps=none", &overridden);
  EXPECT_EQ(overridden.bumps.height, 0);
}

struct Case {
  std::string input, message;
};

TEST(Settings, OfAModelAreRefusedWithNameRuleAndValue) {
  const std::string body = R"(<element objtype="body" objname="w"/>)";
  const std::string geom = R"(<element objtype="geom" objname="g"/>)";
  for (const Case& c : std::vector<Case>{
           {Numeric("clock", "-1"), "<custom> softsoil_clock: must be 0.0001 to 10 s, got -1"},
           {Numeric("clock", "0.1 0.2"), "<custom> softsoil_clock: must be one number, got 2"},
           {Numeric("volumes", "2.5"),
            "<custom> softsoil_volumes: must be a whole number, got 2.5"},
           {Numeric("volumes", "0"), "<custom> softsoil_volumes: must be 1 to 1000, got 0"},
           {Numeric("grid_spacing", "0.0005"),
            "<custom> softsoil_grid_spacing: must be 0.001 to 10 m, got 0.0005"},
           {Numeric("volume_height", "11"),
            "<custom> softsoil_volume_height: must be 0.001 to 10 m, got 11"},
           {Numeric("threads", "1025"), "<custom> softsoil_threads: must be 1 to 1024, got 1025"},
           {Numeric("sync", "2"), "<custom> softsoil_sync: must be 0 to 1, got 2"},
           {Text("clock", "0.1"), "<custom> softsoil_clock: must be a <numeric>, got a <text>"},
           {Numeric("soil", "1"), "<custom> softsoil_soil: must be a <text>, got a <numeric>"},
           {Text("wheels", "w"), "<custom> softsoil_wheels: must be a <tuple>, got a <text>"},
           {Text("mode", "solid"),
            "<custom> softsoil_mode: must be flow or compaction, got \"solid\""},
           {Text("stress", "fast"),
            "<custom> softsoil_stress: must be one of direct, gaussian, auto, got \"fast\""},
           {Text("rigid_contact", "no"),
            "<custom> softsoil_rigid_contact: must be warn or remove, got \"no\""},
           {Text("tire", "a b"),
            "<custom> softsoil_tire: must be one tire for all wheels, BODY=TIRE entries or both, "
            "got \"a b\""},
           {Numeric("bumps", "0.1"), "<custom> softsoil_bumps: must be a <text>, got a <numeric>"},
           {Text("bumps", "0.1 0.5"),
            "<custom> softsoil_bumps: must be HEIGHT,SPACING or HEIGHT,SPACING,SEED or none, got "
            "\"0.1 0.5\""},
           {Text("sol", "mud"),
            "<custom> softsoil_sol: unknown key; known are: softsoil_soil, softsoil_regions, "},
           {"<tuple name=\"softsoil_wheels\">" + body + geom + "</tuple>",
            "<custom> softsoil_wheels: must refer to bodies; element 2 does not"},
       }) {
    EXPECT_THAT(Refusal(FromModel, c.input), HasSubstr(c.message)) << c.input;
  }
}

TEST(Settings, InATextAreRefusedWithNameRuleAndValue) {
  for (const Case& c : std::vector<Case>{
           {"clock=forty", "settings: clock: must be a finite number, got \"forty\""},
           {"clock=0.1x", "settings: clock: must be a finite number, got \"0.1x\""},
           {"clock=", "settings: clock: must be a finite number, got \"\""},
           {"clock=0x1p-7", "settings: clock: must be a finite number, got \"0x1p-7\""},
           {"clock=0,01", "settings: clock: must be a finite number, got \"0,01\""},
           {"clock=nan", "settings: clock: must be a finite number, got \"nan\""},
           {"clock", "settings: clock: must be followed by = and a value"},
           {"clock=1 clock=2", "settings: clock: is given twice"},
           {"soil=", "settings: soil: must not be empty"},
           {"wheels=", "settings: wheels: must name a body"},
           {"bumps=0.1",
            "bumps: must be HEIGHT,SPACING or HEIGHT,SPACING,SEED or none, got \"0.1\""},
           {"bumps=0.1,,2",
            "must be HEIGHT,SPACING or HEIGHT,SPACING,SEED or none, got \"0.1,,2\""},
           {"bumps=0.1,2,3,4", "HEIGHT,SPACING,SEED or none, got \"0.1,2,3,4\""},
           {"bumps=some", "HEIGHT,SPACING,SEED or none, got \"some\""},
           {"bumps=0,2", "bumps: the height must be 0.0001 to 10 m, got \"0\""},
           {"bumps=-0.1,2", "bumps: the height must be 0.0001 to 10 m, got \"-0.1\""},
           {"bumps=nan,2", "bumps: the height must be 0.0001 to 10 m, got \"nan\""},
           {"bumps=0.1,wide", "bumps: the spacing must be 0.01 to 1000 m, got \"wide\""},
           {"bumps=0.001,0.009", "bumps: the spacing must be 0.01 to 1000 m, got \"0.009\""},
           {"bumps=0.11,0.2",
            "bumps: the height must be at most 0.5 times the spacing, got "
            "\"0.11,0.2\""},
           {"bumps=0.1,2,-1", "bumps: the seed must be 0 to 999999, got \"-1\""},
           {"bumps=0.1,2,1.5", "bumps: the seed must be a whole number, got \"1.5\""},
           {"regions=road", "regions: must be SITE=SOIL entries or none, got \"road\""},
           {"regions==mud", "regions: must be SITE=SOIL entries or none, got \"=mud\""},
           {"regions=road=", "regions: must be SITE=SOIL entries or none, got \"road=\""},
           {"regions=,", "regions: must name something, got \",\""},
           {"regions=a=mud,a=clay", "regions: must have one soil for each site, got two for \"a\""},
           {"speed=1", "settings: speed: unknown key; known are: soil, regions, tire, "},
       }) {
    EXPECT_THAT(Refusal(FromText, c.input), HasSubstr(c.message)) << c.input;
  }
}

}  // namespace
}  // namespace softsoil
