#include "plugin/cli/entry_output.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "plugin/cli/picture.h"
#include "terrain/input_error.h"
#include "terrain/output_file.h"

namespace softsoil {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> Wanted(const EntryFiles& files) {
  std::vector<std::string> wanted;
  for (const std::string& file : {files.xml, files.picture, files.json}) {
    if (!file.empty()) wanted.push_back(file);
  }
  return wanted;
}

void RequireEnding(const std::optional<std::string>& file, const char* option, const char* ending) {
  if (!file || fs::path(*file).extension() == ending) return;
  throw InputError(std::string(option) + " must end in " + ending + ", got \"" + *file + "\"");
}

void RequireFree(const std::string& file, bool force, const std::vector<std::string>& inputs) {
  std::error_code error;
  if (fs::is_directory(file, error)) throw InputError(file + ": is a folder, not a file");
  RequireNoInput(file, inputs);
  const fs::file_status status = fs::symlink_status(file, error);
  if (status.type() == fs::file_type::not_found) return;
  if (status.type() == fs::file_type::none) throw InputError(file + ": " + error.message());
  if (force) return;
  throw InputError(file + ": is there already; --force overwrites it");
}

void WriteWhole(const std::string& path, const std::string& text) {
  OutputFile file(path);
  file.Write(text);
  file.Finish();
}

}  // namespace

void RequireEntryName(const std::string& name, const std::string& kind,
                      const std::vector<std::string>& taken) {
  if (name.empty()) throw InputError("--out needs --name: the name of the " + kind);
  // Settings stand between blanks or semicolons and the names in them between commas; = stands
  // before a name, and @ before the inflation pressure of a tire.
  if (name.find_first_of(" \t\r\n\v\f,;=@") != std::string::npos) {
    throw InputError("--name must hold no blank, comma, semicolon, = or @, got \"" + name + "\"");
  }
  RequirePlainText("--name", name);
  if (std::find(taken.begin(), taken.end(), name) != taken.end()) {
    throw InputError("--name " + name + ": this name is taken already");
  }
}

void RequirePlainText(const char* option, const std::string& text) {
  const auto is_control = [](unsigned char c) { return c < ' ' || c == 0x7f; };
  bool plain = std::none_of(text.begin(), text.end(), is_control);
  try {
    nlohmann::json(text).dump();  // checks the encoding
  } catch (const nlohmann::json::type_error&) {
    plain = false;
  }
  if (!plain) {
    throw InputError(std::string(option) + " must be UTF-8 without control characters");
  }
}

EntryFiles EntryFilesOf(const EntryFileOptions& options, bool is_fit) {
  RequireEnding(options.out, "--out", ".xml");
  RequireEnding(options.picture, "--picture", ".png");
  if (options.picture && options.no_picture) {
    throw InputError("--picture and --no-picture exclude one another");
  }
  EntryFiles files;
  files.xml = options.out.value_or("");
  if (options.picture) {
    files.picture = *options.picture;
  } else if (options.out && is_fit && !options.no_picture) {
    files.picture = fs::path(*options.out).replace_extension(".png");
  }
  const std::string beside = files.picture.empty() ? files.xml : files.picture;
  if (!beside.empty()) files.json = fs::path(beside).replace_extension(".json");
  return files;
}

void PrepareEntryFiles(const EntryFiles& files, bool force,
                       const std::vector<std::string>& inputs) {
  for (const std::string& file : Wanted(files)) RequireFree(file, force, inputs);
  for (const std::string& file : Wanted(files)) {
    const fs::path folder = fs::path(file).parent_path();
    PrepareFolder(folder.empty() ? "." : folder.string());
  }
}

// The entry last: where it is, the rest is too.
void WriteEntryFiles(const EntryFiles& files, const EntryTexts& texts, const std::string& python,
                     const std::string& script) {
  if (files.json.empty()) return;
  WriteWhole(files.json, texts.report);
  if (!files.picture.empty()) Draw(python, script, {files.json, files.picture}, files.picture);
  if (!files.xml.empty()) WriteWhole(files.xml, texts.entry);
  std::printf("\n");
  for (const std::string& file : Wanted(files)) std::printf("written: %s\n", file.c_str());
}

}  // namespace softsoil
