// softsoil with: starts any MuJoCo program with libsoftsoil.so preloaded.
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "plugin/cli/commands.h"
#include "plugin/cli/exit_code.h"
#include "plugin/cli/paths.h"

namespace softsoil {
namespace {

struct WithOptions {
  std::string on_error;
  std::vector<std::string> program;  // and its arguments
};

// Put before what is preloaded already.
void PreloadSoil() {
  std::string preload = SoftsoilLibrary();
  if (preload.find_first_of(" :") != std::string::npos) {
    throw std::runtime_error(preload + ": LD_PRELOAD cannot hold a path with a space or colon; " +
                             "install softsoil elsewhere");
  }
  const char* present = std::getenv("LD_PRELOAD");
  if (present != nullptr && *present != '\0') preload += std::string(":") + present;
  setenv("LD_PRELOAD", preload.c_str(), 1);
}

// Returns only if the program cannot be started.
void Start(WithOptions& options) {
  PreloadSoil();
  if (!options.on_error.empty()) setenv("SOFTSOIL_ON_ERROR", options.on_error.c_str(), 1);
  std::vector<char*> arguments;
  arguments.reserve(options.program.size() + 1);
  for (std::string& word : options.program) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  execvp(arguments[0], arguments.data());
}

}  // namespace

void AddWithCommand(CLI::App& program) {
  CLI::App* command =
      program.add_subcommand("with", "Start any MuJoCo program with soft soil under its wheels");
  command->footer("For example: softsoil with -- mujoco-simulate truck.xml");
  auto options = std::make_shared<WithOptions>();
  command
      ->add_option("--on-error", options->on_error,
                   "What the program does after bad input of softsoil: stop, or continue without "
                   "soil")
      ->check(CLI::IsMember({"stop", "continue"}));
  command->add_option("program", options->program, "Program and its arguments, after --")
      ->required();
  command->callback([options] {
    Start(*options);
    std::fprintf(stderr, "softsoil: %s: %s\n", options->program[0].c_str(), std::strerror(errno));
    std::exit(kNoSuchProgram);
  });
}

}  // namespace softsoil
