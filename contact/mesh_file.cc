#include "contact/mesh_file.h"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <sstream>

#include "terrain/input_error.h"

namespace softsoil {
namespace {

using Eigen::Vector3d;

constexpr std::size_t kStlHeader = 80, kStlTriangle = 50;  // [bytes]
// OBJ statements that say nothing about the shape of a polygon mesh.
constexpr const char* kObjIgnored[] = {"vt", "vn", "g", "o", "s", "usemtl", "mtllib"};
constexpr std::size_t kMostCorners = std::numeric_limits<int>::max();

std::string BytesOf(const std::string& file) {
  std::error_code ignored;
  const auto status = std::filesystem::status(file, ignored);
  if (is_directory(status)) throw InputError(file + ": is a folder, not a file");
  // A device or a pipe may have no end.
  if (exists(status) && !is_regular_file(status)) throw InputError(file + ": is no regular file");
  const std::uintmax_t size = exists(status) ? std::filesystem::file_size(file, ignored) : 0;
  if (size >= kMostCorners) {
    throw InputError(file + ": must be smaller than " + std::to_string(kMostCorners) +
                     " bytes, got " + std::to_string(size));
  }
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw InputError(file + ": cannot read: " + std::strerror(errno));
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::string InLowerCase(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

// The words of a text file, line by line.
class Lines {
 public:
  Lines(const std::string& file, const std::string& text) : file_(file), stream_(text) {}

  // The next line that has words; false at the end. Comments start with #.
  bool Next(std::vector<std::string>* words) {
    std::string line;
    while (std::getline(stream_, line)) {
      ++number_;
      std::istringstream rest(line.substr(0, line.find('#')));
      words->assign(std::istream_iterator<std::string>(rest), {});
      if (!words->empty()) return true;
    }
    return false;
  }

  [[noreturn]] void Refuse(const std::string& rule) const {
    throw InputError(file_ + ":" + std::to_string(std::max(number_, 1)) + ": " + rule);
  }

  Vector3d Point(const std::vector<std::string>& words, std::size_t first) const {
    Vector3d point;
    for (int k = 0; k < 3; ++k) {
      const std::string word = first + k < words.size() ? words[first + k] : "";
      const bool has_plus = word.size() > 1 && word[0] == '+' && word[1] != '-';
      if (!ParseNumber(word.substr(has_plus ? 1 : 0), &point[k])) {
        Refuse("a vertex must be three finite numbers, got " + Quoted(word));
      }
    }
    return point;
  }

 private:
  std::string file_;
  std::istringstream stream_;
  int number_ = 0;
};

// The vertex that a corner of an OBJ face names: 7, 7/1/2, or -1 for the last one so far.
int ObjCorner(const Lines& lines, const std::string& word, std::size_t vertices) {
  double number = 0;
  const bool is_whole = ParseNumber(word.substr(0, word.find('/')), &number) &&
                        number == std::floor(number) && number != 0;
  const auto count = static_cast<double>(vertices);
  if (!is_whole || std::abs(number) > count) {
    lines.Refuse("a corner must be one of the " + std::to_string(vertices) +
                 " vertices so far, got " + Quoted(word));
  }
  return static_cast<int>(number > 0 ? number - 1 : count + number);
}

void AddObjFace(const Lines& lines, const std::vector<std::string>& words, TriangleMesh* mesh) {
  if (words.size() < 4) {
    lines.Refuse("a face must have at least 3 corners, got " + std::to_string(words.size() - 1));
  }
  std::vector<int> corners;
  for (std::size_t k = 1; k < words.size(); ++k) {
    corners.push_back(ObjCorner(lines, words[k], mesh->vertices.size()));
  }
  for (std::size_t k = 2; k < corners.size(); ++k) {
    mesh->triangles.push_back({corners[0], corners[k - 1], corners[k]});
  }
}

TriangleMesh ParseObj(const std::string& file, const std::string& text) {
  TriangleMesh mesh;
  Lines lines(file, text);
  std::vector<std::string> words;
  while (lines.Next(&words)) {
    if (words[0] == "v") {
      mesh.vertices.push_back(lines.Point(words, 1));
    } else if (words[0] == "f") {
      AddObjFace(lines, words, &mesh);
    } else if (std::find(std::begin(kObjIgnored), std::end(kObjIgnored), words[0]) ==
               std::end(kObjIgnored)) {
      lines.Refuse("a statement must be v, f, " +
                   Listed({std::begin(kObjIgnored), std::end(kObjIgnored)}) + ", got " +
                   Quoted(words[0]));
    }
  }
  return mesh;
}

void AddTriangle(const std::array<Vector3d, 3>& corners, TriangleMesh* mesh) {
  const int first = static_cast<int>(mesh->vertices.size());
  mesh->vertices.insert(mesh->vertices.end(), corners.begin(), corners.end());
  mesh->triangles.push_back({first, first + 1, first + 2});
}

// After "facet": everything to "endfacet".
std::array<Vector3d, 3> StlFacet(Lines& lines) {
  std::array<Vector3d, 3> corners;
  std::vector<std::string> words;
  const auto expect = [&](const std::string& word) {
    const bool is_there = lines.Next(&words);
    const std::string found = is_there ? InLowerCase(words[0]) : "the end of the file";
    if (found != word) lines.Refuse("expected \"" + word + "\", got " + Quoted(found));
  };
  expect("outer");
  for (Vector3d& corner : corners) {
    expect("vertex");
    corner = lines.Point(words, 1);
  }
  expect("endloop");
  expect("endfacet");
  return corners;
}

TriangleMesh ParseTextStl(const std::string& file, const std::string& text) {
  TriangleMesh mesh;
  Lines lines(file, text);
  std::vector<std::string> words;
  bool is_open = false;
  while (lines.Next(&words)) {
    const std::string word = InLowerCase(words[0]);
    if (word == "facet" && is_open) {
      AddTriangle(StlFacet(lines), &mesh);
    } else if (word == (is_open ? "endsolid" : "solid")) {
      is_open = !is_open;
    } else {
      lines.Refuse(std::string("expected ") + (is_open ? "facet or endsolid" : "solid") + ", got " +
                   Quoted(words[0]));
    }
  }
  if (is_open) lines.Refuse("endsolid is missing: the file is cut off");
  return mesh;
}

std::uint32_t LittleEndian(const char* bytes) {
  std::uint32_t number = 0;
  for (int k = 3; k >= 0; --k) number = number << 8 | static_cast<unsigned char>(bytes[k]);
  return number;
}

double FloatAt(const char* bytes) {
  const std::uint32_t bits = LittleEndian(bytes);
  float value = 0;
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

// Bytes that a binary STL file has by its count of triangles; 0 if it is too short to have one.
std::size_t BinaryStlSize(const std::string& bytes) {
  if (bytes.size() < kStlHeader + 4) return 0;
  return kStlHeader + 4 + kStlTriangle * std::size_t{LittleEndian(bytes.data() + kStlHeader)};
}

TriangleMesh ParseBinaryStl(const std::string& bytes) {
  TriangleMesh mesh;
  for (std::size_t at = kStlHeader + 4; at < bytes.size(); at += kStlTriangle) {
    std::array<Vector3d, 3> corners;
    for (int k = 0; k < 9; ++k) {
      double& x = corners[k / 3][k % 3] = FloatAt(bytes.data() + at + 12 + 4 * k);
      if (std::isfinite(x)) continue;
      throw InputError("triangle " + std::to_string(mesh.triangles.size() + 1) +
                       ": its corners must be finite, got " + std::to_string(x));
    }
    AddTriangle(corners, &mesh);
  }
  return mesh;
}

// The header of a binary file may start with "solid" too; its size does not lie.
TriangleMesh ParseStl(const std::string& file, const std::string& bytes) {
  const std::size_t binary = BinaryStlSize(bytes);
  if (bytes.size() == binary) return At(file, [&] { return ParseBinaryStl(bytes); });
  const std::size_t first = bytes.find_first_not_of(" \t\r\n");
  if (first != std::string::npos && InLowerCase(bytes.substr(first, 5)) == "solid") {
    return ParseTextStl(file, bytes);
  }
  throw InputError(
      file + ": " +
      (binary == 0 ? "an STL file must start with \"solid\" or have a header of 84 bytes, got " +
                         std::to_string(bytes.size()) + " bytes"
                   : "a binary STL file of so many triangles must have " + std::to_string(binary) +
                         " bytes, got " + std::to_string(bytes.size())));
}

TriangleMesh Parse(const std::string& file, const std::string& bytes) {
  const std::string ending = InLowerCase(std::filesystem::path(file).extension().string());
  if (ending == ".obj") return ParseObj(file, bytes);
  if (ending == ".stl") return ParseStl(file, bytes);
  throw InputError(file + ": its name must end in .obj or .stl, got \"" + ending + "\"");
}

}  // namespace

TriangleMesh ReadMesh(const std::string& file, double scale) {
  TriangleMesh mesh = Parse(file, BytesOf(file));
  for (Vector3d& vertex : mesh.vertices) vertex *= scale;
  mesh = WithVerticesMerged(mesh);
  At(file, [&] { RequireClosed(mesh); });
  return mesh;
}

}  // namespace softsoil
