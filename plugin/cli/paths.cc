#include "plugin/cli/paths.h"

#include <tinyxml2.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "terrain/input_error.h"
#include "terrain/xml_catalogue.h"

namespace softsoil {
namespace {

namespace fs = std::filesystem;

fs::path Prefix() { return fs::read_symlink("/proc/self/exe").parent_path().parent_path(); }

// Up to the first full stop, semicolon or end of line.
std::string FirstSentence(const std::string& text) {
  const std::string blank = " \t\r\n";
  const std::size_t first = text.find_first_not_of(blank);
  if (first == std::string::npos) return "";
  const std::size_t last = std::min({text.find(". ", first), text.find(".\n", first),
                                     text.find("; ", first), text.find('\n', first)});
  std::string sentence = text.substr(first, last == std::string::npos ? last : last - first);
  sentence.erase(sentence.find_last_not_of(blank + ".") + 1);
  return sentence;
}

std::string Description(const std::string& file) {
  tinyxml2::XMLDocument document;
  if (document.LoadFile(file.c_str()) != tinyxml2::XML_SUCCESS) {
    throw InputError(file + ":" + std::to_string(document.ErrorLineNum()) + ": " +
                     document.ErrorStr());
  }
  for (const auto* node = document.FirstChild(); node != nullptr; node = node->NextSibling()) {
    if (node->ToComment() != nullptr) return FirstSentence(node->Value());
  }
  const char* model = document.RootElement()->Attribute("model");
  return model != nullptr ? model : "";
}

}  // namespace

std::string ShareFolder() { return Prefix() / "share" / "softsoil"; }

std::string SoftsoilLibrary() {
  const fs::path library = Prefix() / "lib" / "libsoftsoil.so";
  if (!fs::exists(library)) throw std::runtime_error(library.string() + ": no such library");
  return library;
}

std::vector<Scene> ShippedScenes() {
  std::vector<Scene> scenes;
  for (const std::string& file : XmlFilesIn(ShareFolder() + "/models/scenes")) {
    scenes.push_back({fs::path(file).stem(), Description(file), file});
  }
  return scenes;
}

std::string SceneFile(const std::string& scene) {
  std::error_code ignored;
  if (fs::is_regular_file(scene, ignored)) return scene;
  std::vector<std::string> known;
  for (const Scene& shipped : ShippedScenes()) {
    if (shipped.name == scene) return shipped.file;
    known.push_back(shipped.name);
  }
  throw InputError("unknown scene \"" + scene + "\": neither an MJCF file nor one of the shipped " +
                   "scenes: " + Listed(known));
}

}  // namespace softsoil
