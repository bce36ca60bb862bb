#include "plugin/cli/picture.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>

#include "plugin/cli/paths.h"
#include "terrain/input_error.h"

namespace softsoil {
namespace {

enum class Messages { kShown, kHidden };

// Runs a program and returns its exit status; 127 if it cannot be started, 128 + signal if it was
// killed.
int Execute(std::vector<std::string> words, Messages messages) {
  std::vector<char*> arguments;
  arguments.reserve(words.size() + 1);
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);

  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  if (messages == Messages::kHidden) {
    posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  }
  pid_t child = 0;
  const int error =
      posix_spawnp(&child, arguments[0], &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0) return 127;

  int status = 0;
  while (waitpid(child, &status, 0) < 0) {
    if (errno != EINTR) throw std::runtime_error(words[0] + ": " + std::strerror(errno));
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace

std::string PythonThatPlots() {
  for (const char* python : {SOFTSOIL_PYTHON, "/usr/bin/python3", "python3"}) {
    if (Execute({python, "-c", "import matplotlib, numpy"}, Messages::kHidden) == 0) return python;
  }
  throw InputError(
      "the picture needs python3 with matplotlib and numpy (Debian: "
      "python3-matplotlib), and none was found; --no-picture runs without");
}

void DrawPictures(const std::string& python, const std::string& folder,
                  const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    Draw(python, name + ".py", {folder}, folder + "/" + name + ".png");
  }
}

void Draw(const std::string& python, const std::string& script,
          const std::vector<std::string>& arguments, const std::string& picture) {
  const std::string path = ShareFolder() + "/plot/" + script;
  std::vector<std::string> words = {python, "-B", path};  // no byte code in the share folder
  words.insert(words.end(), arguments.begin(), arguments.end());
  const int status = Execute(words, Messages::kShown);
  if (status == 0) return;
  throw std::runtime_error(picture + ": " + path + " failed with exit status " +
                           std::to_string(status));
}

}  // namespace softsoil
