// What softsoil soil and fit-tire write: an entry of a catalogue, the picture of its fit and the
// numbers behind it.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace softsoil {

// Throws InputError if the name of a new soil or tire is empty, holds a letter that ends a name in
// a setting, or is taken.
void RequireEntryName(const std::string& name, const std::string& kind,
                      const std::vector<std::string>& taken);

// Throws InputError unless a text that goes into XML and JSON is UTF-8 without control characters.
void RequirePlainText(const char* option, const std::string& text);

struct EntryFiles {
  std::string xml, picture, json;  // empty: not wanted
};

// The options --out FILE.xml, --picture FILE.png and --no-picture.
struct EntryFileOptions {
  std::optional<std::string> out, picture;
  bool no_picture;
};
// The picture stands beside the entry if no other place is given and there `is_fit`, something to
// draw; the numbers beside the picture. Throws InputError for another ending.
EntryFiles EntryFilesOf(const EntryFileOptions& options, bool is_fit);

// Makes the folders. Before that, throws InputError if a file is there already, unless it may be
// overwritten by `force`; one of the `inputs` may never be.
void PrepareEntryFiles(const EntryFiles& files, bool force,
                       const std::vector<std::string>& inputs = {});

struct EntryTexts {
  std::string entry, report;  // of .xml and .json
};
// Writes the files and says so; `script` draws the picture from the report.
void WriteEntryFiles(const EntryFiles& files, const EntryTexts& texts, const std::string& python,
                     const std::string& script);

}  // namespace softsoil
