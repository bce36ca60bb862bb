// Tire files: those that come with the program, and how bad ones are refused.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "contact/tire.h"
#include "tests/terrain/catalogue_case.h"

namespace softsoil {
namespace {

const std::string kTorus = R"(<tires>
<tire name="fat">
<shape type="torus" radius="0.91" crown_radius="0.661" width="0.467" source="a test"/>
<spring root="346900" damping="8900" source="a test"/>
<friction coefficient="0.65" source="a test"/>
</tire>
</tires>
)";
const std::string kCylinder = Replaced(kTorus, R"(type="torus" radius="0.91" crown_radius="0.661")",
                                       R"(type="cylinder" radius="0.91")");

Tire Read(const std::string& xml) {
  Catalogue<Tire> tires = TireCatalogue();
  tires.AddFile(WriteFile("tire.xml", xml));
  return tires.Find("fat");
}

// The sentence after the file's name with which its text is refused; empty if it is taken.
std::string Refusal(const std::string& xml) {
  const std::string path = WriteFile("tire.xml", xml);
  return RefusalAt(path, [&] { TireCatalogue().AddFile(path); });
}

Catalogue<Tire> Shipped() {
  Catalogue<Tire> tires = TireCatalogue();
  tires.AddFolder(SOFTSOIL_SOURCE_DIR "/models/tires");
  return tires;
}

TEST(TireCatalogue, ReadsEveryFileThatComesWithTheProgram) {
  const Catalogue<Tire> tires = Shipped();
  EXPECT_GE(tires.entries().size(), 5u);
  for (const char* name : {"18.4R38_85kPa", "18.4R38_125kPa", "24.5R32_85kPa", "37x12.5R16.5_15psi",
                           "37x12.5R16.5_35psi"}) {
    EXPECT_EQ(tires.Find(name).name, name);
    EXPECT_NE(tires.Find(name).description, "");
  }
}

// Madsen (2014), 6.2.1 and Table 6.1; the section is 18.4 inches wide.
TEST(TireCatalogue, HasTheTractorTireOfTheThesis) {
  const Tire tire = Shipped().Find("18.4R38_85kPa");
  EXPECT_DOUBLE_EQ(tire.shape.radius, 0.91);
  EXPECT_DOUBLE_EQ(tire.shape.crown_radius, 0.661);
  EXPECT_NEAR(tire.shape.width, 18.4 * 0.0254, 0.001);
  EXPECT_DOUBLE_EQ(tire.spring.root, 3.469e5);
  EXPECT_EQ(tire.spring.linear, 0);
}

// Madsen (2014), 4.2.1: a = 7.99 and 14.7, in psi/in.
TEST(TireCatalogue, HasTheTruckTireOfTheThesis) {
  const double psi_per_inch = 6894.757 / 0.0254;
  const Tire soft = Shipped().Find("37x12.5R16.5_15psi"),
             hard = Shipped().Find("37x12.5R16.5_35psi");
  EXPECT_EQ(soft.spring.root, 0);
  EXPECT_NEAR(soft.spring.linear / (7.99 * psi_per_inch), 1, 1e-4);
  EXPECT_NEAR(hard.spring.linear / (14.7 * psi_per_inch), 1, 1e-4);
  EXPECT_TRUE(std::isinf(soft.shape.crown_radius));
  EXPECT_NEAR(soft.shape.radius, 37 * 0.0254 / 2, 1e-4);
  EXPECT_NEAR(soft.shape.width, 12.5 * 0.0254, 1e-4);
}

TEST(TireCatalogue, HoldsPlausibleTiresOnly) {
  const Catalogue<Tire> tires = Shipped();
  for (const Tire& tire : tires.entries()) {
    SCOPED_TRACE(tire.name);
    EXPECT_GT(tire.shape.radius, 0.2);
    EXPECT_LT(tire.shape.radius, 1.5);
    EXPECT_LT(tire.shape.width, tire.shape.radius);
    EXPECT_GE(tire.shape.crown_radius, tire.shape.width / 2);
    EXPECT_GT(SpringPressure(tire.spring, 0.05), 30e3);
    EXPECT_LT(SpringPressure(tire.spring, 0.05), 400e3);
    EXPECT_GT(tire.soil_friction, 0.3);
    EXPECT_LT(tire.soil_friction, 1);
  }
}

TEST(TireFile, FillsEveryField) {
  const Tire torus = Read(kTorus);
  EXPECT_EQ(torus.shape.radius, 0.91);
  EXPECT_EQ(torus.shape.crown_radius, 0.661);
  EXPECT_EQ(torus.shape.width, 0.467);
  EXPECT_EQ(torus.spring.root, 346900);
  EXPECT_EQ(torus.spring.linear, 0);
  EXPECT_EQ(torus.damping, 8900);
  EXPECT_EQ(torus.soil_friction, 0.65);
  EXPECT_TRUE(std::isinf(Read(kCylinder).shape.crown_radius));
}

TEST(TireFile, MayBeATextThatIsNoFileYet) {
  Catalogue<Tire> tires = TireCatalogue();
  tires.AddText(kTorus, "new.xml");
  ASSERT_EQ(tires.entries().size(), 1u);
  EXPECT_EQ(tires.entries()[0].spring.root, 346900);
  EXPECT_EQ(RefusalAt("new.xml", [&] { tires.AddText(kTorus, "new.xml"); }),
            ":2: <tire name=\"fat\">: this name is taken already");
  EXPECT_EQ(RefusalAt("new.xml", [&] { tires.AddText("<tires>", "new.xml"); }).substr(0, 3), ":1:");
}

TEST(TireFile, AddsUpTheTermsOfASpring) {
  const TireSpring spring =
      Read(Replaced(kTorus, "root=\"346900\"",
                    "linear=\"1e6\" quadratic=\"2e6\" cubic=\"3e6\" root=\"4e5\""))
          .spring;
  EXPECT_DOUBLE_EQ(SpringPressure(spring, 0.25), 0.25e6 + 0.125e6 + 3e6 / 64 + 2e5);
}

TEST(TireFile, RefusesASpringWithoutAnyTerm) {
  const std::string rule =
      ":2: <tire name=\"fat\">: the spring must have one of linear, quadratic, cubic, root > 0";
  EXPECT_EQ(Refusal(Replaced(kTorus, " root=\"346900\"", "")), rule);
  EXPECT_EQ(Refusal(Replaced(kTorus, "346900", "0")), rule);
}

// The torus file with an attribute replaced by `text`, or with `text` added if it is left out.
std::string With(const Attribute<Tire>& attribute, const std::string& text) {
  const std::size_t element = kTorus.find(std::string("<") + attribute.element + " ");
  const std::size_t end = kTorus.find("/>", element);
  std::string inside = kTorus.substr(element, end - element);
  const std::size_t start = inside.find(" " + std::string(attribute.name) + "=\"");
  if (start == std::string::npos) {
    inside += text;
  } else {
    const std::size_t last = inside.find('"', inside.find('"', start) + 1);
    inside.replace(start, last + 1 - start, text);
  }
  return kTorus.substr(0, element) + inside + kTorus.substr(end);
}

TEST(TireFile, RequiresEveryAttributeThatIsNotOptional) {
  ASSERT_GE(TireAttributes().size(), 5u);
  for (const Attribute<Tire>& attribute : TireAttributes()) {
    if (attribute.optional) continue;
    const std::string refusal = Refusal(With(attribute, ""));
    EXPECT_EQ(refusal.substr(refusal.find(": ") + 2), std::string("<tire name=\"fat\"> <") +
                                                          attribute.element + ">: attribute " +
                                                          attribute.name + " is missing");
  }
}

TEST(TireFile, RefusesEveryAttributeOutsideItsRange) {
  for (const Attribute<Tire>& attribute : TireAttributes()) {
    const std::string name = attribute.name;
    const std::string unit = *attribute.unit != '\0' ? " " + std::string(attribute.unit) : "";
    const std::string refusal = Refusal(With(attribute, " " + name + "=\"-1\""));
    EXPECT_EQ(refusal.substr(refusal.find(">: ") + 3),
              name + " must be " + InWords(attribute.range) + unit + ", got -1");
  }
}

TEST(TireFile, RefusesACrownRadiusSmallerThanHalfTheWidth) {
  EXPECT_EQ(Refusal(Replaced(kTorus, "0.661", "0.2")),
            ":2: <tire name=\"fat\">: crown_radius must be >= width / 2 = 0.2335 m, got 0.2");
  EXPECT_EQ(Refusal(Replaced(kTorus, "0.661", "0.2335")), "");
}

TEST(TireFile, RequiresTheCrownRadiusOfATorus) {
  EXPECT_EQ(Refusal(Replaced(kTorus, " crown_radius=\"0.661\"", "")),
            ":3: <tire name=\"fat\"> <shape>: attribute crown_radius is missing");
}

TEST(TireFile, RefusesACrownRadiusOfACylinder) {
  EXPECT_EQ(Refusal(Replaced(kTorus, "torus", "cylinder")),
            ":3: <tire name=\"fat\"> <shape>: unknown attribute crown_radius");
}

TEST(TireFile, RefusesUnknownShapes) {
  EXPECT_EQ(Refusal(Replaced(kTorus, "torus", "ball")),
            ":3: <tire name=\"fat\"> <shape>: type must be one of torus, cylinder, got \"ball\"");
  EXPECT_EQ(Refusal(Replaced(kTorus, "torus", "")),
            ":3: <tire name=\"fat\"> <shape>: type must not be empty");
}

TEST(TireFile, RefusesAMissingSource) {
  EXPECT_EQ(Refusal(Replaced(kTorus, " source=\"a test\"", "")),
            ":3: <tire name=\"fat\"> <shape>: attribute source is missing: say where the numbers "
            "come from");
}

TEST(TireFile, RefusesASoilFile) {
  EXPECT_EQ(Refusal("<soils/>"), ":1: expected the root <tires>, got <soils>");
}

}  // namespace
}  // namespace softsoil
