#include "plugin/cli/run.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <set>

#include "plugin/cli/contact_log.h"
#include "plugin/cli/mujoco_messages.h"
#include "plugin/cli/npy.h"
#include "plugin/cli/paths.h"
#include "plugin/cli/picture.h"
#include "plugin/cli/progress.h"
#include "plugin/cli/result_folder.h"
#include "plugin/cli/run_steps.h"
#include "plugin/cli/simulation.h"
#include "plugin/cli/summary.h"
#include "plugin/cli/wheel_log.h"
#include "terrain/input_error.h"

namespace softsoil {
namespace {

constexpr double kAveragedOver = 1;  // [s]

std::vector<std::string> Results() {
  return {"wheels.csv",  "contact.csv", "terrain.npy", "summary.json",
          "terrain.png", "contact.png", "profile.png"};
}

void RequirePositive(const char* option, double value) {
  if (std::isfinite(value) && value > 0) return;
  throw InputError(std::string(option) + " must be > 0 s, got " + Shown(value));
}

// The steps at whose start the contact is asked for.
std::set<long> ContactSteps(const std::vector<double>& contact_times, const RunSteps& steps) {
  std::set<long> chosen;
  for (const double time : contact_times) chosen.insert(steps.Nearest("--contact-times", time));
  return chosen;
}

// Files by the step at whose start the state is saved.
std::multimap<long, std::string> FilesByStep(const std::vector<StateSave>& saves,
                                             const RunSteps& steps) {
  std::multimap<long, std::string> files;
  for (const StateSave& save : saves) {
    files.emplace(steps.Nearest("--save-state", save.time), save.file);
  }
  return files;
}

// When something is to be done besides stepping.
struct Plan {
  RunSteps steps;
  long first_averaged;                      // step
  std::set<long> contacts;                  // steps, besides the end
  std::multimap<long, std::string> states;  // files by step

  Plan(const RunOptions& options, const RunSteps& run)
      : steps(run),
        first_averaged(
            std::max(run.first(), run.last() - std::lround(kAveragedOver / run.time_step()))),
        contacts(ContactSteps(options.contact_times, run)),
        states(FilesByStep(options.save_states, run)) {}
};

// Steps a simulation to its end and collects what it tells of its wheels.
class Drive {
 public:
  Drive(Simulation& simulation, const Controls& controls, const RunOptions& options,
        const Plan& plan)
      : simulation_(simulation),
        controls_(controls),
        interval_(options.interval),
        plan_(plan),
        log_(options.folder + "/wheels.csv"),
        contact_log_(options.folder + "/contact.csv"),
        progress_(plan.steps.duration()) {
    if (options.profile) profiler_.emplace(simulation);
  }

  RunResult ToTheEnd() {
    const RunSteps& steps = plan_.steps;
    for (const softsoilWheel& w : simulation_.Wheels()) result_.wheels.push_back({w.name, {}});
    for (long step = steps.first(); step < steps.last(); ++step) {
      if (steps.Begins(step, interval_)) Log();
      if (plan_.contacts.count(step) > 0) LogContact();
      SaveStates(step);
      Step(step);
    }
    Log();
    LogContact();
    SaveStates(steps.last());
    log_.Finish();
    contact_log_.Finish();
    TellTotals();
    return result_;
  }

 private:
  void Log() {
    simulation_.EvaluateWheels();
    log_.Write(simulation_.Time(), simulation_.Wheels());
  }

  void LogContact() {
    simulation_.EvaluateWheels();
    const std::vector<softsoilWheel> wheels = simulation_.Wheels();
    for (std::size_t i = 0; i < wheels.size(); ++i) {
      contact_log_.Write(simulation_.Time(), wheels[i], simulation_.Contacts(static_cast<int>(i)));
    }
  }

  void SaveStates(long step) {
    const auto [begin, end] = plan_.states.equal_range(step);
    for (auto file = begin; file != end; ++file) {
      simulation_.EvaluateWheels();  // the same file whether or not a row was written before it
      simulation_.SaveState(file->second);
    }
  }

  void Step(long step) {
    if (profiler_) profiler_->BeginStep();
    simulation_.Step(controls_);
    if (profiler_) profiler_->EndStep();
    if (step >= plan_.first_averaged) Average();
    result_.wall_time =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begun_).count();
    progress_.Show(simulation_.Time() - plan_.steps.start(), result_.wall_time);
  }

  void Average() {
    const std::vector<softsoilWheel> wheels = simulation_.Wheels();
    for (std::size_t i = 0; i < wheels.size(); ++i) result_.wheels[i].mean.Add(wheels[i]);
  }

  void TellTotals() {
    const RunSteps& steps = plan_.steps;
    result_.time_step = steps.time_step();
    result_.start_time = steps.start();
    result_.simulated_time = steps.duration();
    result_.averaged_over = (steps.last() - plan_.first_averaged) * steps.time_step();
    result_.ground = simulation_.Ground();
    result_.state_hash = simulation_.StateHash();
    if (profiler_) result_.profile = profiler_->Of(result_.wall_time);
  }

  Simulation& simulation_;
  const Controls& controls_;
  double interval_;  // [s]
  Plan plan_;
  WheelLog log_;
  ContactLog contact_log_;
  Progress progress_;
  std::optional<Profiler> profiler_;
  std::chrono::steady_clock::time_point begun_ = std::chrono::steady_clock::now();
  RunResult result_;
};

void WriteTerrain(const Simulation& simulation, const std::string& folder) {
  std::vector<float> rows;  // x, y, height, sinkage [m]
  const auto append = [](void* user, double x, double y, double height, double sinkage) {
    auto& table = *static_cast<std::vector<float>*>(user);
    for (const double value : {x, y, height, sinkage}) table.push_back(static_cast<float>(value));
  };
  simulation.VisitSurface(append, &rows);
  WriteNpy(folder + "/terrain.npy", rows, 4);
}

}  // namespace

void Run(const RunOptions& options) {
  RequirePositive("--time", options.time);
  RequirePositive("--interval", options.interval);
  const std::string scene = SceneFile(options.scene);
  const std::string python = options.picture ? PythonThatPlots() : "";

  HandleMujocoMessages();
  Simulation simulation(scene);
  Controls controls;
  if (!options.controls.empty()) controls = Controls(options.controls, simulation.Actuators());
  simulation.GiveSoil(options.settings);
  if (!options.load_state.empty()) simulation.LoadState(options.load_state);
  const RunSteps steps(simulation.Time(), options.time, simulation.model().opt.timestep);
  const Plan plan(options, steps);
  const std::vector<std::string> inputs = {scene, options.controls, options.load_state};
  RequirePlaces(options.save_states, options.folder, Results(), inputs);
  const ResultFolder folder(options.folder, Results(), inputs);
  RemoveOlder(options.save_states);

  const RunResult result = Drive(simulation, controls, options, plan).ToTheEnd();
  WriteTerrain(simulation, options.folder);
  WriteSummary(options, result);
  if (options.picture) DrawPictures(python, options.folder, {"terrain", "contact"});
  if (options.picture && options.profile) DrawPictures(python, options.folder, {"profile"});
  PrintSummary(options, result);
}

}  // namespace softsoil
