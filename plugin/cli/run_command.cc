// The command line of softsoil run.
#include <algorithm>
#include <cctype>
#include <memory>
#include <string>
#include <vector>

#include "plugin/cli/commands.h"
#include "plugin/cli/run.h"
#include "terrain/input_error.h"

namespace softsoil {
namespace {

// softsoil_attach() takes settings separated by blanks, hence there are none inside.
void CheckSetting(const std::string& setting) {
  const std::size_t equals = setting.find('=');
  const bool blank = std::any_of(setting.begin(), setting.end(),
                                 [](unsigned char c) { return std::isspace(c) != 0; });
  if (equals == std::string::npos || equals == 0 || equals + 1 == setting.size() || blank) {
    throw InputError("a setting must be KEY=VALUE without blanks, got \"" + setting + "\"");
  }
}

struct Line {
  RunOptions options;
  bool no_picture = false;

  void Add(const std::vector<std::string>& settings) {
    for (const std::string& setting : settings) {
      CheckSetting(setting);
      options.settings += (options.settings.empty() ? "" : " ") + setting;
    }
  }
};

// An option whose value becomes the setting `key`. Its text is passed on as it is: the library
// says what is wrong with a value.
CLI::Option* AddSetting(CLI::App& command, const std::shared_ptr<Line>& line,
                        const std::string& option, const std::string& key,
                        const std::string& help) {
  const auto pass = [line, key](const std::string& value) { line->Add({key + "=" + value}); };
  return command.add_option_function<std::string>(option, pass, help);
}

}  // namespace

void AddRunCommand(CLI::App& program) {
  CLI::App* command = program.add_subcommand("run", "Run a scene and write what the wheels did");
  auto line = std::make_shared<Line>();
  RunOptions& options = line->options;
  command->add_option("scene", options.scene, "MJCF file, or name of a shipped scene")->required();
  command
      ->add_option("--time", options.time,
                   "Time to simulate [s]; with --load-state, from the time of the state on")
      ->required();
  command->add_option("--out", options.folder, "Folder for the results")->required();
  command->add_option("--controls", options.controls,
                      "CSV file: a column time [s], and one for each actuator to be driven, linear "
                      "between rows");
  command
      ->add_option("--interval", options.interval, "Simulated time between rows of wheels.csv [s]")
      ->capture_default_str();
  command
      ->add_option("--contact-times", options.contact_times,
                   "Times at which contact.csv tells the contact of the tires, besides the end: "
                   "T1,T2,... [s]")
      ->delimiter(',')
      ->allow_extra_args(false);
  command
      ->add_option_function<std::vector<std::string>>(
          "--save-state",
          [line](const std::vector<std::string>& given) {
            for (const std::string& text : given) {
              line->options.save_states.push_back(StateSaveIn(text));
            }
          },
          "Save the state of soil and model at the simulated time T [s] into FILE, from which "
          "--load-state "
          "goes on; an older state there is replaced; may be given several times")
      ->type_name("T:FILE")
      ->allow_extra_args(false);
  command
      ->add_option(
          "--load-state", options.load_state,
          "Go on from the state in FILE, of the same scene and settings, as if the run had "
          "not been interrupted; --controls, --contact-times and --save-state go by "
          "simulated time, which goes on too")
      ->type_name("FILE");
  command->add_flag("--no-picture", line->no_picture,
                    "Do not draw terrain.png and contact.png, which need python3 with matplotlib");
  command->add_flag("--profile", options.profile,
                    "Tell where the wall time went, in summary.json and profile.png");
  AddSetting(*command, line, "--threads", "threads", "Threads of the soil update");
  AddSetting(*command, line, "--soil-clock", "clock", "Simulated time between soil updates [s]");
  AddSetting(*command, line, "--mode", "mode",
             "How the surface sinks: flow, or by compaction alone")
      ->check(CLI::IsMember({"flow", "compaction"}));
  command->add_flag_callback(
      "--sync", [line] { line->Add({"sync=1"}); },
      "Update the soil in place instead of in the background");
  command
      ->add_option_function<std::vector<std::string>>(
          "--set", [line](const std::vector<std::string>& given) { line->Add(given); },
          "A softsoil_KEY of the model's <custom>, overridden; may be given several times")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
  command->callback([line] {
    line->options.picture = !line->no_picture;
    Run(line->options);
  });
}

}  // namespace softsoil
