// Tire files whose tire has the surface of a mesh.
#include <gmock/gmock.h>

#include "contact/tire.h"
#include "terrain/input_error.h"
#include "tests/contact/mesh_samples.h"
#include "tests/terrain/catalogue_case.h"

namespace softsoil {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

const GrouserWheel kWheel = {0.15, 0.1, 0.01, 0.004, 12, 5};
const std::string kTire = R"(<tires>
<tire name="rover">
<shape type="cylinder" radius="0.16" width="0.1" source="a test"/>
<mesh file="MESH" source="a test"/>
<spring linear="1e8" damping="0" source="a test"/>
<friction coefficient="0.5" source="a test"/>
</tire>
</tires>
)";

// Files of one test: the mesh, and an XML file beside it that names it without a folder.
Tire Read(const std::string& xml, double scale = 1,
          const Eigen::Vector3d& middle = Eigen::Vector3d::Zero()) {
  TriangleMesh mesh = kWheel.Mesh();
  for (Eigen::Vector3d& v : mesh.vertices) v = scale * v + middle;
  const std::string file = WriteFile("wheel.obj", Obj(mesh));
  const std::string name = file.substr(file.rfind('/') + 1);
  Catalogue<Tire> tires = TireCatalogue();
  tires.AddFile(WriteFile("tire.xml", Replaced(xml, "MESH", name)));
  return tires.Find("rover");
}

auto Refuses(const std::string& rule) { return ThrowsMessage<InputError>(HasSubstr(rule)); }

TEST(MeshTire, HasTheMeshOfTheFileBesideItsOwn) {
  const Tire tire = Read(kTire);
  ASSERT_NE(tire.mesh, nullptr);
  EXPECT_NEAR(Volume(*tire.mesh) / Volume(kWheel.Mesh()), 1, 1e-4);
  EXPECT_EQ(tire.shape.radius, 0.16);
}

TEST(MeshTire, MayBeInMillimetres) {
  const Tire tire = Read(Replaced(kTire, R"(file="MESH")", R"(file="MESH" scale="0.001")"), 1000);
  EXPECT_NEAR(Volume(*tire.mesh) / Volume(kWheel.Mesh()), 1, 1e-4);
}

TEST(MeshTire, MustHaveTheSizeOfItsShape) {
  EXPECT_THAT([] { Read(Replaced(kTire, "0.16", "0.15")); },
              Refuses(R"(:2: <tire name="rover">: radius must be that of the mesh, 0.16)"));
  EXPECT_THAT([] { Read(Replaced(kTire, R"(width="0.1")", R"(width="0.2")")); },
              Refuses("width must be that of the mesh, 0.1 m about its y axis, got 0.2"));
  EXPECT_THAT([] { Read(kTire, 1000); }, Refuses("mesh"));
}

TEST(MeshTire, MustBeInTheMiddleOfItsTread) {
  EXPECT_THAT(
      [] {
        Read(kTire, 1, {0, 0.2, 0});
      },
      Refuses(R"(:2: <tire name="rover">: the mesh must have its middle at y = 0 m, got 0.2)"));
}

TEST(MeshTire, MustNotBeOfAFileThatIsNotThere) {
  EXPECT_THAT([] { Read(Replaced(kTire, "MESH", "none/MESH")); },
              Refuses(R"(:2: <tire name="rover">: /)"));
  EXPECT_THAT([] { Read(Replaced(kTire, "MESH", "MESH.dae")); }, Refuses(".dae"));
}

TEST(MeshTire, HasNoLugsNorInflationNorCrownBesides) {
  EXPECT_THAT(
      [] {
        Read(Replaced(kTire, "<spring",
                      R"(<inflation family="f" pressure="1e5" source="a"/><spring)"));
      },
      Refuses("a tire with a <mesh> must have no <inflation>"));
  EXPECT_THAT(
      [] {
        Read(Replaced(
            kTire, "<spring",
            R"(<lugs height="0.01" count="9" angle_deg="45" void_share="0.7" source="a"/><spring)"));
      },
      Refuses("a tire with a <mesh> must have no <lugs>"));
  EXPECT_THAT([] { Read(Replaced(kTire, R"("cylinder")", R"("torus" crown_radius="1")")); },
              Refuses("a tire with a <mesh> must have the shape cylinder, got torus"));
}

}  // namespace
}  // namespace softsoil
