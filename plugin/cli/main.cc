// The program softsoil: runs scenes, lists what is shipped, identifies soils, starts other programs
// with soil.
#include <cstdio>
#include <cstring>
#include <exception>
#include <string>

#include "plugin/cli/commands.h"
#include "plugin/cli/exit_code.h"
#include "terrain/input_error.h"

namespace softsoil {
namespace {

std::string BadUsage(const CLI::App*, const CLI::Error& error) {
  return std::string("softsoil: ") + error.what() + "; see softsoil --help\n";
}

// An empty value would count as one that is not given.
void RefuseEmptyArguments(int argc, char** argv) {
  for (int i = 1; i < argc && std::strcmp(argv[i], "--") != 0; ++i) {
    if (*argv[i] == '\0') {
      throw InputError(std::string("an argument is empty: the one after ") + argv[i - 1]);
    }
  }
}

int ParseAndRun(int argc, char** argv) {
  RefuseEmptyArguments(argc, argv);
  CLI::App program("Soft soil under the wheels of any MuJoCo model.", "softsoil");
  program.set_version_flag("--version", SOFTSOIL_VERSION);
  program.require_subcommand(1);
  program.failure_message(BadUsage);
  AddRunCommand(program);
  AddWithCommand(program);
  AddListCommand(program);
  AddSoilCommand(program);
  AddFitTireCommand(program);
  AddDrawbarCommand(program);
  AddWongReeceCommand(program);
  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return program.exit(error) == 0 ? kSuccess : kBadInput;
  }
  return kSuccess;
}

int Report(const std::exception& error, int exit_code) {
  std::fprintf(stderr, "softsoil: %s\n", error.what());
  return exit_code;
}

}  // namespace
}  // namespace softsoil

// The fence: every error ends here as one message and an exit code.
int main(int argc, char** argv) {
  try {
    return softsoil::ParseAndRun(argc, argv);
  } catch (const softsoil::InputError& error) {
    return softsoil::Report(error, softsoil::kBadInput);
  } catch (const std::exception& error) {
    return softsoil::Report(error, softsoil::kFailed);
  }
}
