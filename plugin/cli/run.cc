#include "plugin/cli/run.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <set>

#include "plugin/cli/contact_log.h"
#include "plugin/cli/mujoco_messages.h"
#include "plugin/cli/npy.h"
#include "plugin/cli/paths.h"
#include "plugin/cli/picture.h"
#include "plugin/cli/progress.h"
#include "plugin/cli/result_folder.h"
#include "plugin/cli/simulation.h"
#include "plugin/cli/summary.h"
#include "plugin/cli/wheel_log.h"
#include "terrain/input_error.h"

namespace softsoil {
namespace {

constexpr double kAveragedOver = 1;  // [s]

constexpr double kMostSteps = 1e10;

void RequirePositive(const char* option, double value) {
  if (std::isfinite(value) && value > 0) return;
  throw InputError(std::string(option) + " must be > 0 s, got " + Shown(value));
}

// Number of steps that make up `time` [s].
long Steps(double time, double time_step) {
  if (time < time_step / 2 || time / time_step > kMostSteps) {
    throw InputError("--time must be one time step, " + Shown(time_step) + " s, to " +
                     Shown(kMostSteps) + " of them, got " + Shown(time));
  }
  return std::max(1L, std::lround(time / time_step));
}

void RequireWithin(double time, const std::vector<double>& contact_times) {
  for (const double t : contact_times) {
    if (t >= 0 && t <= time) continue;
    throw InputError("--contact-times must be 0 to --time, " + Shown(time) + " s, got " + Shown(t));
  }
}

// The steps at whose start the contact is asked for.
std::set<long> ContactSteps(const std::vector<double>& contact_times, double time_step) {
  std::set<long> steps;
  for (const double time : contact_times) steps.insert(std::lround(time / time_step));
  return steps;
}

// Steps a simulation to its end and collects what it tells of its wheels.
class Drive {
 public:
  Drive(Simulation& simulation, const Controls& controls, const RunOptions& options)
      : simulation_(simulation),
        controls_(controls),
        interval_(options.interval),
        time_step_(simulation.model().opt.timestep),
        steps_(Steps(options.time, time_step_)),
        first_averaged_(std::max(0L, steps_ - std::lround(kAveragedOver / time_step_))),
        contact_steps_(ContactSteps(options.contact_times, time_step_)),
        log_(options.folder + "/wheels.csv"),
        contact_log_(options.folder + "/contact.csv"),
        progress_(options.time) {}

  RunResult ToTheEnd() {
    result_.time_step = time_step_;
    result_.averaged_over = (steps_ - first_averaged_) * time_step_;
    for (const softsoilWheel& w : simulation_.Wheels()) result_.wheels.push_back({w.name, {}});
    const auto start = std::chrono::steady_clock::now();
    for (long step = 0; step < steps_; ++step) {
      if (contact_steps_.count(step) > 0) LogContact();
      if (step * time_step_ > rows_ * interval_ - time_step_ / 2) Log();
      simulation_.Step(controls_);
      if (step >= first_averaged_) Average();
      result_.wall_time =
          std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
      progress_.Show(simulation_.Time(), result_.wall_time);
    }
    Log();
    LogContact();
    log_.Finish();
    contact_log_.Finish();
    result_.simulated_time = steps_ * time_step_;
    result_.ground = simulation_.Ground();
    return result_;
  }

 private:
  void Log() {
    simulation_.EvaluateWheels();
    log_.Write(simulation_.Time(), simulation_.Wheels());
    rows_ = 1 + std::floor((simulation_.Time() + time_step_ / 2) / interval_);
  }

  void LogContact() {
    simulation_.EvaluateWheels();
    const std::vector<softsoilWheel> wheels = simulation_.Wheels();
    for (std::size_t i = 0; i < wheels.size(); ++i) {
      contact_log_.Write(simulation_.Time(), wheels[i], simulation_.Contacts(static_cast<int>(i)));
    }
  }

  void Average() {
    const std::vector<softsoilWheel> wheels = simulation_.Wheels();
    for (std::size_t i = 0; i < wheels.size(); ++i) result_.wheels[i].mean.Add(wheels[i]);
  }

  Simulation& simulation_;
  const Controls& controls_;
  double interval_;               // [s]
  double time_step_;              // [s]
  long steps_;                    // of the whole run
  long first_averaged_;           // step
  double rows_ = 0;               // intervals begun
  std::set<long> contact_steps_;  // besides the end
  WheelLog log_;
  ContactLog contact_log_;
  Progress progress_;
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
  RequireWithin(options.time, options.contact_times);
  const std::string scene = SceneFile(options.scene);
  const std::string python = options.picture ? PythonThatPlots() : "";

  HandleMujocoMessages();
  Simulation simulation(scene);
  Controls controls;
  if (!options.controls.empty()) controls = Controls(options.controls, simulation.Actuators());
  simulation.GiveSoil(options.settings);
  const ResultFolder folder(
      options.folder,
      {"wheels.csv", "contact.csv", "terrain.npy", "summary.json", "terrain.png", "contact.png"},
      {scene, options.controls});

  const RunResult result = Drive(simulation, controls, options).ToTheEnd();
  WriteTerrain(simulation, options.folder);
  WriteSummary(options, result);
  if (options.picture) DrawPictures(python, options.folder, {"terrain", "contact"});
  PrintSummary(options, result);
}

}  // namespace softsoil
