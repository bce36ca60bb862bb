#include "plugin/cli/torque_history.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "contact/tire_nodes.h"
#include "plugin/cli/bin_rig.h"
#include "plugin/cli/progress.h"
#include "plugin/cli/wheel_log.h"

namespace softsoil {
namespace {

constexpr double kInterval = 0.05;  // [s]  between rows, and over which a centre line is a mean
constexpr double kSample = 0.005;   // [s]  between instants of that mean

}  // namespace

TorqueHistory DriveByTorque(const DrawbarOptions& options, const Tire& tire, Simulation* rig) {
  const bool settled = SettleBraked(options.load, rig);
  rig->SetControl(kTorque, options.torque);

  const CentreLine none(RingsOf(tire, rig->Ground().grid_spacing));
  std::vector<CentreLine> means(options.contact_times.size(), none);
  WheelLog log(options.folder + "/history.csv");
  Progress progress(options.time);
  const double h = rig->model().opt.timestep;
  const auto steps = [h](double time) { return std::lround(time / h); };
  const long last = steps(options.time), sample = std::max(1L, steps(kSample));
  const auto start = std::chrono::steady_clock::now();
  for (long step = 0; step <= last; ++step) {
    if (step % std::max(1L, steps(kInterval)) == 0) log.Write(step * h, rig->Wheels());
    for (std::size_t k = 0; k < means.size(); ++k) {
      const long until = steps(options.contact_times[k]);
      const bool counts = step <= until && step > until - steps(kInterval);
      if (counts && (until - step) % sample == 0) means[k].Add(rig->Contacts(0));
    }
    if (step == last) break;
    StepUnlessSunk(options.load, rig);
    progress.Show(step * h,
                  std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  log.Finish();
  TorqueHistory history = {settled, {}};
  for (std::size_t k = 0; k < means.size(); ++k) {
    history.centre_lines.emplace_back(options.contact_times[k], means[k].Points());
  }
  return history;
}

}  // namespace softsoil
