#include "contact/mesh_file.h"

#include <gmock/gmock.h>

#include <cstdint>
#include <cstring>

#include "terrain/input_error.h"
#include "tests/contact/mesh_samples.h"
#include "tests/terrain/output_folder.h"

namespace softsoil {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

const GrouserWheel kWheel = {0.15, 0.1, 0.015, 0.004, 12, 5};

void Append(std::uint32_t number, std::string* bytes) {
  for (int k = 0; k < 4; ++k) *bytes += static_cast<char>(number >> 8 * k & 255);
}

void Append(float value, std::string* bytes) {
  std::uint32_t bits = 0;
  std::memcpy(&bits, &value, 4);
  Append(bits, bytes);
}

std::string BinaryStl(const TriangleMesh& mesh, const std::string& header = "made by a test") {
  std::string bytes = header + std::string(80 - header.size(), ' ');
  Append(static_cast<std::uint32_t>(mesh.triangles.size()), &bytes);
  for (const std::array<int, 3>& corners : mesh.triangles) {
    for (int k = 0; k < 3; ++k) Append(0.0f, &bytes);
    for (const int corner : corners) {
      for (int k = 0; k < 3; ++k) {
        Append(static_cast<float>(mesh.vertices[corner][k]), &bytes);
      }
    }
    bytes += std::string(2, '\0');
  }
  return bytes;
}

class MeshFile : public OutputFolder {
 protected:
  std::string Write(const std::string& name, const std::string& content) {
    const std::string path = folder_ + "/" + name;
    std::ofstream(path, std::ios::binary) << content;
    return path;
  }

  // What reading the content says after the name of the file.
  std::string Refusal(const std::string& name, const std::string& content) {
    const std::string path = Write(name, content);
    try {
      ReadMesh(path);
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), StartsWith(path + ":"));
      return std::string(error.what()).substr(path.size());
    }
    return "";
  }

  void ExpectSame(const TriangleMesh& read, const TriangleMesh& written, double within) {
    ASSERT_EQ(read.vertices.size(), written.vertices.size());
    ASSERT_EQ(read.triangles.size(), written.triangles.size());
    for (std::size_t t = 0; t < read.triangles.size(); ++t) {
      for (int k = 0; k < 3; ++k) {
        const Eigen::Vector3d& a = read.vertices[read.triangles[t][k]];
        const Eigen::Vector3d& b = written.vertices[written.triangles[t][k]];
        EXPECT_NEAR((a - b).norm(), 0, within) << t;
      }
    }
  }
};

TEST_F(MeshFile, IsTheSameMeshInEveryFormat) {
  const TriangleMesh wheel = kWheel.Mesh();
  ExpectSame(ReadMesh(Write("w.obj", Obj(wheel))), wheel, 1e-6);
  ExpectSame(ReadMesh(Write("e.obj", Obj(wheel, true))), wheel, 1e-6);
  ExpectSame(ReadMesh(Write("t.stl", TextStl(wheel))), wheel, 1e-6);
  ExpectSame(ReadMesh(Write("b.STL", BinaryStl(wheel))), wheel, 1e-7);
  // Some programs write this header into binary files.
  ExpectSame(ReadMesh(Write("s.stl", BinaryStl(wheel, "solid wheel"))), wheel, 1e-7);
}

TEST_F(MeshFile, MayBeInMillimetres) {
  const std::string path = Write("b.stl", BinaryStl(BoxMesh(300, 200, 100)));
  EXPECT_NEAR(Volume(ReadMesh(path, 0.001)), 0.006, 1e-9);
}

TEST_F(MeshFile, MayHavePolygonsTexturesNormalsAndSigns) {
  const std::string box =
      "mtllib a.mtl\n"
      "v 0 0 0\nv +1 0 0\nv 1 1e0 0 1\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1 # last\n"
      "vn 0 0 1\nvt 0 0\n\ng sides\ns off\nusemtl steel\n"
      "f 4/1/1 3//1 2/1 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\r\nf 4 1 5 8\n";
  EXPECT_NEAR(Volume(ReadMesh(Write("a.obj", box))), 1, 1e-15);
}

TEST_F(MeshFile, NamesWhatIsWrongWithAMesh) {
  TriangleMesh open = BoxMesh(1, 1, 1);
  open.triangles.pop_back();
  EXPECT_THAT(Refusal("a.obj", Obj(open)), StartsWith(": triangle 11: its edge from (-0.5, "));
  EXPECT_THAT(Refusal("a.stl", TextStl(open)), HasSubstr("the mesh is open there"));
  EXPECT_THAT(Refusal("b.stl", BinaryStl(open)), HasSubstr("the mesh is open there"));
  EXPECT_EQ(Refusal("c.stl", BinaryStl({})), ": there must be triangles, got none");
  EXPECT_EQ(Refusal("d.stl", BinaryStl(BoxMesh(300, 1, 1))),
            ": the mesh must be at most 100 m long, got 300 m; is it in millimetres?");
}

TEST_F(MeshFile, IsRefusedIfItCannotBeRead) {
  EXPECT_THAT([&] { ReadMesh(folder_ + "/none.stl"); },
              testing::ThrowsMessage<InputError>(
                  folder_ + "/none.stl: cannot read: No such file or directory"));
  std::filesystem::create_directories(folder_ + "/f.stl");
  EXPECT_THAT([&] { ReadMesh(folder_ + "/f.stl"); },
              testing::ThrowsMessage<InputError>(folder_ + "/f.stl: is a folder, not a file"));
  std::filesystem::create_symlink("/dev/zero", folder_ + "/endless.stl");
  EXPECT_THAT([&] { ReadMesh(folder_ + "/endless.stl"); },
              testing::ThrowsMessage<InputError>(folder_ + "/endless.stl: is no regular file"));
  EXPECT_EQ(Refusal("a.ply", ""), ": its name must end in .obj or .stl, got \".ply\"");
}

TEST_F(MeshFile, NamesTheLineOfABrokenObj) {
  EXPECT_EQ(Refusal("a.obj", "v 0 0 \x1b[2J\n"),
            ":1: a vertex must be three finite numbers, got \"?[2J\"");
  EXPECT_EQ(Refusal("a.obj", std::string(1000, 'x') + "\n"),
            ":1: a statement must be v, f, vt, vn, g, o, s, usemtl, mtllib, got \"" +
                std::string(40, 'x') + "...\"");
  EXPECT_EQ(Refusal("a.obj", "v 0 0\n"), ":1: a vertex must be three finite numbers, got \"\"");
  EXPECT_EQ(Refusal("a.obj", "#\n\nv 0 nan 0\n"),
            ":3: a vertex must be three finite numbers, got \"nan\"");
  EXPECT_EQ(Refusal("a.obj", "v 0 0 0\nf 1 1\n"), ":2: a face must have at least 3 corners, got 2");
  for (const char* corner : {"2", "0", "-2", "1.5", "x", "", "1e300"}) {
    if (*corner == 0) continue;
    EXPECT_EQ(
        Refusal("a.obj", std::string("v 0 0 0\nf 1 1 ") + corner),
        std::string(":2: a corner must be one of the 1 vertices so far, got \"") + corner + "\"");
  }
  EXPECT_EQ(Refusal("a.obj", "curv 0 1\n"),
            ":1: a statement must be v, f, vt, vn, g, o, s, usemtl, mtllib, got \"curv\"");
}

TEST_F(MeshFile, NamesTheLineOfABrokenStl) {
  const std::string facet = "solid\nfacet normal 0 0 1\nouter loop\n";
  EXPECT_EQ(Refusal("a.stl", "solid\nfacet\nvertex 0 0 0\n"),
            ":3: expected \"outer\", got \"vertex\"");
  EXPECT_EQ(Refusal("a.stl", facet + "vertex 0 0 inf\n"),
            ":4: a vertex must be three finite numbers, got \"inf\"");
  EXPECT_EQ(Refusal("a.stl", facet + "vertex 0 0 0\n"),
            ":4: expected \"vertex\", got \"the end of the file\"");
  EXPECT_EQ(Refusal("a.stl", "solid\nsolid\n"), ":2: expected facet or endsolid, got \"solid\"");
  EXPECT_EQ(Refusal("a.stl", "solid\n"), ":1: endsolid is missing: the file is cut off");
}

TEST_F(MeshFile, IsRefusedIfABinaryStlIsCutOffOrNotFinite) {
  const std::string box = BinaryStl(BoxMesh(1, 1, 1));
  EXPECT_EQ(Refusal("a.stl", box.substr(0, box.size() - 1)),
            ": a binary STL file of so many triangles must have 684 bytes, got 683");
  EXPECT_EQ(Refusal("a.stl", "short"),
            ": an STL file must start with \"solid\" or have a header of 84 bytes, got 5 bytes");
  TriangleMesh broken = BoxMesh(1, 1, 1);
  broken.vertices[0].x() = INFINITY;
  EXPECT_EQ(Refusal("a.stl", BinaryStl(broken)),
            ": triangle 2: its corners must be finite, got inf");
}

}  // namespace
}  // namespace softsoil
