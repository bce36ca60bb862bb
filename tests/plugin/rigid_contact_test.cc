#include "plugin/rigid_contact.h"

#include <gmock/gmock.h>

#include <utility>
#include <vector>

#include "tests/plugin/one_wheel.h"

namespace softsoil {
namespace {

using testing::HasSubstr;

int AsBuiltIn(const mjModel* m, mjData*, int geom1, int geom2) {
  return MayCollide(m, geom1, geom2) ? 0 : 1;
}

std::vector<std::pair<int, int>> Contacts(const Model& m, mjfConFilt filter) {
  const Data d = MakeData(m);
  const mjfConFilt before = std::exchange(mjcb_contactfilter, filter);
  mj_forward(m.get(), d.get());
  mjcb_contactfilter = before;
  std::vector<std::pair<int, int>> contacts;
  for (int i = 0; i < d->ncon; ++i) {
    contacts.emplace_back(d->contact[i].geom1, d->contact[i].geom2);
  }
  return contacts;
}

// Bodies in a heap: welded, parent and child, excluded, with and without matching bits.
const char kHeap[] = R"(
    <geom type="plane" size="5 5 1"/> <geom size=".3"/>
    <body name="a"><freejoint/><geom size=".2"/><geom size=".21" contype="0" conaffinity="0"/>
      <body><geom size=".22"/>
        <body name="b"><joint/><geom size=".2" contype="4" conaffinity="2"/>
          <body><joint/><geom size=".2" contype="2"/></body></body></body></body>
    <body name="c"><freejoint/><geom size=".2" contype="6" conaffinity="0"/></body>
    <body><geom size=".2"/></body>)";

TEST(RigidContact, FilterDoesWhatTheBuiltInOneDoes) {
  for (const char* option : {"", R"(<option><flag filterparent="disable"/></option>)"}) {
    const Model m = Load(
        World(kHeap, std::string(option) + R"(<contact><exclude body1="b" body2="c"/></contact>)"));
    const auto expected = Contacts(m, nullptr);
    EXPECT_GT(expected.size(), 8u);
    EXPECT_EQ(Contacts(m, AsBuiltIn), expected);
  }
}

std::string Warning(const OneWheel& model, bool filtered = false) {
  const Model m = Load(model.Mjcf());
  const int ground = mj_name2id(m.get(), mjOBJ_GEOM, "field");
  return RigidContactWarning(m.get(), ground, FindWheels(m.get(), {}), filtered);
}

TEST(RigidContact, IsNotWarnedOfWhereThereIsNone) {
  OneWheel model;
  EXPECT_EQ(Warning(model), "");
  model.plane = "";
  model.others = R"(<contact><exclude body1="world" body2="wheel"/></contact>)";
  EXPECT_EQ(Warning(model), "");
}

TEST(RigidContact, IsWarnedOfWithTheMjcfToWrite) {
  OneWheel model;
  model.plane =
      R"(contype="1" conaffinity="1"/><geom name="rock" type="box" size="1 1 1" pos="5 0 0")";
  EXPECT_EQ(Warning(model),
            "the rigid geom \"field\" carries wheels instead of the soil: geom \"tread\". Write "
            "<text name=\"softsoil_rigid_contact\" data=\"remove\"/> into <custom>; or give geom "
            "\"field\" contype=\"2\" conaffinity=\"0\"");
  model.plane = "";
  model.wheel_geom += R"(/><geom name="lug" mass="1" type="box" size=".1 .1 .1")";
  EXPECT_THAT(Warning(model), HasSubstr("instead of the soil: geom \"tread\", geom \"lug\". "));
  EXPECT_EQ(Warning(model, true), "");
}

TEST(RigidContact, IsWarnedOfWithTheBitsThatOtherGeomsNeed) {
  const Model m = Load(World(R"(
      <geom name="field" type="plane" size="5 5 1" contype="1" conaffinity="1"/>
      <body><freejoint/><geom type="box" size="1 .5 .2" conaffinity="5"/>
        <body><joint axis="0 1 0"/><geom name="tread" size=".4"/></body></body>)"));
  EXPECT_THAT(RigidContactWarning(m.get(), 0, FindWheels(m.get(), {}), false),
              HasSubstr("or give geom \"field\" contype=\"2\" conaffinity=\"0\", and to every geom "
                        "but those of the wheels conaffinity=\"7\" where it is \"5\""));
}

TEST(RigidContact, OfAnExplicitPairIsWarnedOfEvenIfFiltered) {
  OneWheel model;
  model.others = R"(<contact><pair geom1="field" geom2="tread"/></contact>)";
  EXPECT_EQ(Warning(model, true),
            "the rigid geom \"field\" carries wheels instead of the soil: delete the <contact> "
            "<pair> with geom \"tread\"");
}

}  // namespace
}  // namespace softsoil
