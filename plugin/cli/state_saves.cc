#include "plugin/cli/state_saves.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <set>

#include "terrain/input_error.h"
#include "terrain/output_file.h"

namespace softsoil {
namespace {

namespace fs = std::filesystem;

// The same however a folder or a file in it is spelled. A link in the place of the file itself is
// not followed: it is replaced.
fs::path Canonical(const fs::path& folder) { return fs::weakly_canonical(fs::absolute(folder)); }
fs::path PlaceOf(const fs::path& file) {
  return Canonical(fs::absolute(file).parent_path()) / file.filename();
}

void RequireFolder(const std::string& file, const fs::path& made_by_run) {
  const fs::path folder = PlaceOf(file).parent_path();
  if (folder == made_by_run && !fs::exists(folder)) return;
  if (!fs::is_directory(folder)) throw InputError(file + ": its folder is not there");
  if (access(folder.c_str(), W_OK | X_OK) == 0) return;
  throw InputError(file + ": cannot write into its folder: " + std::strerror(errno));
}

bool IsStateFile(const fs::path& file) {
  const std::string magic = "softsoil state\n";
  std::string start(magic.size(), '\0');
  std::ifstream(file, std::ios::binary).read(start.data(), start.size());
  return start == magic;
}

// What stands there already.
void RequireReplaceable(const std::string& file) {
  const fs::path name = fs::path(file).filename();
  if (name.empty() || name == "." || name == ".." || fs::is_directory(file)) {
    throw InputError(file + ": is a folder, not a file");
  }
  if (fs::is_directory(file + ".part"))
    throw InputError(file + ".part: is a folder, and in the way");
  if (fs::exists(file) && !(fs::is_regular_file(file) && IsStateFile(file))) {
    throw InputError(file + ": is there and is no state file: it would be lost");
  }
}

void RequirePlace(const std::string& file, const std::string& made_by_run) {
  try {
    RequireReplaceable(file);
    RequireFolder(file, Canonical(made_by_run));
  } catch (const fs::filesystem_error& error) {
    throw InputError(file + ": cannot be written: " + error.code().message());
  }
}

}  // namespace

StateSave StateSaveIn(const std::string& text) {
  const std::size_t colon = text.find(':');
  StateSave save;
  if (colon == std::string::npos || colon + 1 == text.size() ||
      !ParseNumber(text.substr(0, colon), &save.time)) {
    throw InputError("--save-state must be T:FILE with T [s], such as 2.5:ruts.state, got \"" +
                     text + "\"");
  }
  save.file = text.substr(colon + 1);
  return save;
}

void RequirePlaces(const std::vector<StateSave>& saves, const std::string& folder,
                   const std::vector<std::string>& results,
                   const std::vector<std::string>& inputs) {
  std::set<fs::path> written;  // complete and while they are being written
  const auto is_first = [&written](const std::string& file) {
    const fs::path place = PlaceOf(file);
    const bool is_new = written.insert(place).second;
    return written.insert(place.string() + ".part").second && is_new;
  };
  for (const std::string& result : results) is_first(folder + "/" + result);
  for (const StateSave& save : saves) {
    RequireNoInput(save.file, inputs);
    RequirePlace(save.file, folder);
    if (!is_first(save.file)) throw InputError(save.file + ": this run would write it twice");
  }
}

void RemoveOlder(const std::vector<StateSave>& saves) {
  std::error_code error;
  for (const StateSave& save : saves) fs::remove(save.file, error);
}

}  // namespace softsoil
