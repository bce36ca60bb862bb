// Reads a catalogue file: a root element, named entries, numbers in elements below each entry.
// Anything unknown, missing, doubled or out of range is an InputError with file and line.
#pragma once

#include <tinyxml2.h>

#include <functional>
#include <set>
#include <string>
#include <vector>

#include "terrain/attribute.h"
#include "terrain/input_error.h"

namespace softsoil {

// One entry, <soil name="..."> or <tire name="...">, while it is read.
class XmlEntry {
 public:
  XmlEntry(std::string file, const tinyxml2::XMLElement& element);

  const std::string& name() const { return name_; }
  const std::string& file() const { return file_; }
  const std::string& description() const { return description_; }

  // The number of <element name="..."/>. Throws when absent, not a number or out of range.
  double Number(const char* element, const char* name, const char* unit, Range range);
  // The text of an attribute; one of `allowed` unless that is empty.
  std::string Text(const char* element, const char* name,
                   const std::vector<std::string>& allowed = {});
  // Numbers between blanks, one at least, each in the range.
  std::vector<double> Numbers(const char* element, const char* name, const char* unit, Range range);
  bool Has(const char* element) const;
  bool Has(const char* element, const char* name) const;

  // Fills the fields of a table. What is optional and left out stays as it is.
  template <class Entry>
  void Fill(const std::vector<Attribute<Entry>>& table, Entry& entry) {
    for (const Attribute<Entry>& a : table) {
      if (a.optional && !Has(a.element, a.name)) continue;
      a.field(entry) = Number(a.element, a.name, a.unit, a.range) * a.to_si;
    }
  }

  // Throws if the entry holds an element or attribute that nobody has asked for.
  void RefuseUnread() const;

  // Throws with the place of the entry.
  [[noreturn]] void Refuse(const std::string& rule) const { Refuse(element_, rule); }

 private:
  [[noreturn]] void Refuse(const tinyxml2::XMLElement& at, const std::string& rule) const;
  const tinyxml2::XMLElement& Child(const char* element) const;
  double Parsed(const std::string& text, const char* element, const char* name, const char* unit,
                Range range) const;
  const char* Value(const char* element, const char* name);

  std::string file_;
  const tinyxml2::XMLElement& element_;
  std::string name_, description_;
  std::set<std::string> read_;  // "element" and "element.attribute" asked for so far
};

// Calls `read` for every <kind> below the root <kinds> of the file, in order. Throws if the file
// cannot be read, is not XML or holds anything else.
void ForEachEntry(const std::string& file, const std::string& kind,
                  const std::function<void(XmlEntry&)>& read);

// The same for the text of a file that is not there yet.
void ForEachEntryIn(const std::string& text, const std::string& file, const std::string& kind,
                    const std::function<void(XmlEntry&)>& read);

// All *.xml files of a folder, sorted by name. Throws if there is no such folder.
std::vector<std::string> XmlFilesIn(const std::string& folder);

// Entries of one kind ("soil", "tire") by name, from any number of files.
template <class Entry>
class Catalogue {
 public:
  using Reader = Entry (*)(XmlEntry&);
  // Throws, by XmlEntry::Refuse, if a new entry does not agree with those that there are.
  using Check = void (*)(const std::vector<Entry>& others, const Entry& fresh, const XmlEntry& xml);
  Catalogue(std::string kind, Reader reader, Check check = nullptr)
      : kind_(std::move(kind)), reader_(reader), check_(check) {}

  // Adds all entries of a file. Throws InputError, also if a name is taken already.
  void AddFile(const std::string& file) {
    ForEachEntry(file, kind_, [this](XmlEntry& xml) { Add(xml); });
  }
  // The same for the text of a file that is not there yet.
  void AddText(const std::string& text, const std::string& file) {
    ForEachEntryIn(text, file, kind_, [this](XmlEntry& xml) { Add(xml); });
  }
  // Adds all *.xml files of a folder.
  void AddFolder(const std::string& folder) {
    for (const std::string& file : XmlFilesIn(folder)) AddFile(file);
  }
  // The catalogue with all *.xml files of a folder and more files besides.
  Catalogue With(const std::string& folder, const std::vector<std::string>& files = {}) && {
    AddFolder(folder);
    for (const std::string& file : files) AddFile(file);
    return std::move(*this);
  }

  // Throws InputError that lists the known names.
  const Entry& Find(const std::string& name) const {
    if (const Entry* entry = Lookup(name)) return *entry;
    std::vector<std::string> known;
    for (const Entry& entry : entries_) known.push_back(entry.name);
    throw InputError("unknown " + kind_ + " \"" + name + "\"; known are: " + Listed(known));
  }
  const std::vector<Entry>& entries() const { return entries_; }

 private:
  void Add(XmlEntry& xml) {
    if (Lookup(xml.name()) != nullptr) xml.Refuse("this name is taken already");
    Entry fresh = reader_(xml);
    if (check_ != nullptr) check_(entries_, fresh, xml);
    entries_.push_back(std::move(fresh));
  }

  const Entry* Lookup(const std::string& name) const {
    for (const Entry& entry : entries_) {
      if (entry.name == name) return &entry;
    }
    return nullptr;
  }

  std::string kind_;
  Reader reader_;
  Check check_;
  std::vector<Entry> entries_;
};

}  // namespace softsoil
