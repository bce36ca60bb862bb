#include "terrain/xml_catalogue.h"

#include <dirent.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <memory>
#include <sstream>

namespace softsoil {
namespace {

constexpr char kSource[] = "source";  // where a group of numbers comes from; each group has one

// What is wrong with a file that tinyxml2 cannot load.
std::string InWords(tinyxml2::XMLError error) {
  switch (error) {
    case tinyxml2::XML_ERROR_FILE_NOT_FOUND: return "there is no such file";
    case tinyxml2::XML_ERROR_FILE_COULD_NOT_BE_OPENED: return "cannot be opened";
    case tinyxml2::XML_ERROR_FILE_READ_ERROR: return "cannot be read; is it a folder?";
    case tinyxml2::XML_ERROR_EMPTY_DOCUMENT: return "holds no element";
    case tinyxml2::XML_ERROR_MISMATCHED_ELEMENT: return "this element is not closed";
    case tinyxml2::XML_ERROR_PARSING_ATTRIBUTE:
      return "an attribute of this element is malformed or stands here twice";
    default: return "is not well-formed XML";
  }
}

bool HoldsText(const tinyxml2::XMLElement& element) {
  const auto* node = element.FirstChild();
  while (node != nullptr && node->ToText() == nullptr) node = node->NextSibling();
  return node != nullptr;
}

}  // namespace

bool Contains(Range range, double value) {
  switch (range) {
    case Range::kAny: return std::isfinite(value);
    case Range::kNotNegative: return value >= 0 && std::isfinite(value);
    case Range::kPositive: return value > 0 && std::isfinite(value);
    case Range::kUpToOne: return value >= 0 && value <= 1;
    case Range::kUpTo90Degrees: return value >= 0 && value < 90;
    case Range::kConcentration: return value >= 3 && value <= 6;
    case Range::kTireSize: return value >= 0.001 && value <= 100;
  }
  return false;
}

std::string InWords(Range range) {
  switch (range) {
    case Range::kAny: return "finite";
    case Range::kNotNegative: return ">= 0";
    case Range::kPositive: return "> 0";
    case Range::kUpToOne: return "0 to 1";
    case Range::kUpTo90Degrees: return ">= 0 and < 90";
    case Range::kConcentration: return "3 to 6";
    case Range::kTireSize: return "0.001 to 100";
  }
  return "";
}

XmlEntry::XmlEntry(std::string file, const tinyxml2::XMLElement& element)
    : file_(std::move(file)), element_(element) {
  const char* name = element.Attribute("name");
  if (name == nullptr || *name == '\0') Refuse("attribute name is missing");
  name_ = name;
  const char* description = element.Attribute("description");
  if (description != nullptr) description_ = description;
}

void XmlEntry::Refuse(const tinyxml2::XMLElement& at, const std::string& rule) const {
  std::string where = std::string("<") + element_.Name() + " name=\"" + name_ + "\">";
  if (&at != &element_) where += std::string(" <") + at.Name() + ">";
  throw InputError(file_ + ":" + std::to_string(at.GetLineNum()) + ": " + where + ": " + rule);
}

bool XmlEntry::Has(const char* element) const {
  return element_.FirstChildElement(element) != nullptr;
}

bool XmlEntry::Has(const char* element, const char* name) const {
  return Has(element) && Child(element).Attribute(name) != nullptr;
}

const tinyxml2::XMLElement& XmlEntry::Child(const char* element) const {
  const tinyxml2::XMLElement* child = element_.FirstChildElement(element);
  if (child == nullptr) Refuse(std::string("element <") + element + "> is missing");
  if (child->NextSiblingElement(element) != nullptr) {
    Refuse(*child->NextSiblingElement(element), "stands here a second time");
  }
  return *child;
}

const char* XmlEntry::Value(const char* element, const char* name) {
  const tinyxml2::XMLElement& child = Child(element);
  const char* text = child.Attribute(name);
  if (text == nullptr) Refuse(child, std::string("attribute ") + name + " is missing");
  read_.insert(element);
  read_.insert(std::string(element) + "." + name);
  return text;
}

double XmlEntry::Number(const char* element, const char* name, const char* unit, Range range) {
  return Parsed(Value(element, name), element, name, unit, range);
}

std::vector<double> XmlEntry::Numbers(const char* element, const char* name, const char* unit,
                                      Range range) {
  std::istringstream words(Value(element, name));
  std::vector<double> numbers;
  for (std::string word; words >> word;) {
    numbers.push_back(Parsed(word, element, name, unit, range));
  }
  if (numbers.empty()) Refuse(Child(element), std::string(name) + " must not be empty");
  return numbers;
}

double XmlEntry::Parsed(const std::string& text, const char* element, const char* name,
                        const char* unit, Range range) const {
  const std::string unit_text = *unit != '\0' ? std::string(" ") + unit : "";
  double value = 0;
  if (!ParseNumber(text, &value)) {
    Refuse(Child(element),
           std::string(name) + " must be a finite number" + unit_text + ", got \"" + text + "\"");
  }
  if (!Contains(range, value)) {
    Refuse(Child(element),
           std::string(name) + " must be " + InWords(range) + unit_text + ", got " + text);
  }
  return value;
}

std::string XmlEntry::Text(const char* element, const char* name,
                           const std::vector<std::string>& allowed) {
  const std::string text = Value(element, name);
  if (text.empty()) Refuse(Child(element), std::string(name) + " must not be empty");
  if (!allowed.empty() && std::find(allowed.begin(), allowed.end(), text) == allowed.end()) {
    Refuse(Child(element),
           std::string(name) + " must be one of " + Listed(allowed) + ", got \"" + text + "\"");
  }
  return text;
}

void XmlEntry::RefuseUnread() const {
  if (HoldsText(element_)) Refuse("must hold elements alone, no text");
  for (const auto* a = element_.FirstAttribute(); a != nullptr; a = a->Next()) {
    if (std::strcmp(a->Name(), "name") != 0 && std::strcmp(a->Name(), "description") != 0) {
      Refuse(std::string("unknown attribute ") + a->Name());
    }
  }
  for (const auto* child = element_.FirstChildElement(); child != nullptr;
       child = child->NextSiblingElement()) {
    const std::string element = child->Name();
    if (read_.count(element) == 0) Refuse("unknown element <" + element + ">");
    if (child->FirstChildElement() != nullptr || HoldsText(*child)) {
      Refuse(*child, "must hold attributes alone");
    }
    const char* source = child->Attribute(kSource);
    if (source == nullptr || *source == '\0') {
      Refuse(*child, "attribute source is missing: say where the numbers come from");
    }
    for (const auto* a = child->FirstAttribute(); a != nullptr; a = a->Next()) {
      if (std::strcmp(a->Name(), kSource) != 0 && read_.count(element + "." + a->Name()) == 0) {
        Refuse(*child, std::string("unknown attribute ") + a->Name());
      }
    }
  }
}

namespace {

void ForEachEntryOf(const tinyxml2::XMLDocument& document, const std::string& file,
                    const std::string& kind, const std::function<void(XmlEntry&)>& read) {
  if (document.Error()) {
    const int line = document.ErrorLineNum();
    throw InputError(file + (line > 0 ? ":" + std::to_string(line) : "") + ": " +
                     InWords(document.ErrorID()));
  }
  const auto refuse = [&file](const tinyxml2::XMLElement& at, const std::string& wanted) {
    throw InputError(file + ":" + std::to_string(at.GetLineNum()) + ": expected " + wanted +
                     ", got <" + at.Name() + ">");
  };
  const tinyxml2::XMLElement* root = document.RootElement();
  if (root == nullptr) throw InputError(file + ": holds no element");
  if (root->Name() != kind + "s") refuse(*root, "the root <" + kind + "s>");
  if (root->NextSiblingElement() != nullptr) refuse(*root->NextSiblingElement(), "one root alone");
  if (root->FirstAttribute() != nullptr || HoldsText(*root)) {
    throw InputError(file + ":" + std::to_string(root->GetLineNum()) + ": <" + root->Name() +
                     "> must hold <" + kind + "> alone");
  }
  for (const auto* e = root->FirstChildElement(); e != nullptr; e = e->NextSiblingElement()) {
    if (e->Name() != kind) refuse(*e, "<" + kind + ">");
    XmlEntry entry(file, *e);
    read(entry);
    entry.RefuseUnread();
  }
}

}  // namespace

void ForEachEntry(const std::string& file, const std::string& kind,
                  const std::function<void(XmlEntry&)>& read) {
  tinyxml2::XMLDocument document;
  document.LoadFile(file.c_str());
  ForEachEntryOf(document, file, kind, read);
}

void ForEachEntryIn(const std::string& text, const std::string& file, const std::string& kind,
                    const std::function<void(XmlEntry&)>& read) {
  tinyxml2::XMLDocument document;
  document.Parse(text.c_str(), text.size());
  ForEachEntryOf(document, file, kind, read);
}

std::vector<std::string> XmlFilesIn(const std::string& folder) {
  // Not std::filesystem::directory_iterator: that of libstdc++ ends the program if memory runs out.
  const std::unique_ptr<DIR, int (*)(DIR*)> entries(opendir(folder.c_str()), &closedir);
  if (entries == nullptr) throw InputError(folder + ": " + std::strerror(errno));
  std::vector<std::string> files;
  while (const dirent* entry = readdir(entries.get())) {
    const std::filesystem::path file = std::filesystem::path(folder) / entry->d_name;
    if (file.extension() == ".xml") files.push_back(file.string());
  }
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace softsoil
