#include "terrain/ground.h"

#include <utility>

namespace softsoil {
namespace {

// A point load is right only below about one spacing (its own node alone gives 2.5 p at dx/2).
constexpr double kNearFieldSpacings = 1.25;

const GroundSettings& Checked(const GroundSettings& s) {
  const auto require = [](const char* name, double value, Limits limits, const char* unit) {
    if (Contains(limits, value)) return;
    throw InputError(std::string(name) + " must be " + InWords(limits) + unit + ", got " +
                     Shown(value));
  };
  require("grid_spacing", s.grid_spacing, kGridSpacingLimits, " m");
  require("volume_height", s.volume_height, kVolumeHeightLimits, " m");
  require("volumes", s.volumes, kVolumesLimits, "");
  require("soil_clock", s.soil_clock, kSoilClockLimits, " s");
  require("threads", s.threads, kThreadsLimits, "");
  return s;
}

}  // namespace

Ground::Ground(const Soil& soil, const GroundSettings& settings, UndisturbedHeight undisturbed,
               int sources)
    : soil_(soil),
      settings_(Checked(settings)),
      surface_(settings.grid_spacing, settings.mode, undisturbed),
      columns_(soil, {settings.grid_spacing, settings.volume_height, settings.volumes}, undisturbed,
               MakeDirectStress({soil.concentration_factor,
                                 kNearFieldSpacings * settings.grid_spacing, settings.threads})),
      clock_(settings.soil_clock),
      work_(sources) {
  for (int source = 0; source < sources; ++source) gatherers_.emplace_back(settings.grid_spacing);
}

Ground::~Ground() {
  if (job_.valid()) job_.wait();
}

void Ground::AddLoad(int source, const std::vector<SurfaceForce>& forces, double h) {
  for (const SurfaceForce& force : forces) gatherers_[source].Add(force, h);
}

void Ground::DeepenPlastic(const std::vector<NodeSinkage>& plastic) {
  for (const NodeSinkage& sinkage : plastic) surface_.DeepenPlastic(sinkage);
}

void Ground::Pass(double h) {
  if (!clock_.Pass(h)) return;
  Join();
  Start(TakeLoad(clock_.Elapsed()), clock_.Elapsed());
  if (settings_.sync) Join();
}

SurfaceLoad Ground::TakeLoad(double period) {
  SurfaceLoad load;
  const auto height = [this](GridNode node) { return surface_.NodeHeight(node); };
  for (std::size_t source = 0; source < gatherers_.size(); ++source) {
    gatherers_[source].TakeMean(static_cast<int>(source), period, height, &load);
  }
  return load;
}

void Ground::Start(SurfaceLoad load, double period) {
  job_period_ = period;
  auto job = [this, load = std::move(load), period] {
    job_result_ = columns_.Advance(load, period);
  };
  if (settings_.sync) {
    job();
  } else {
    job_ = WorkerPool::Shared().Run(std::move(job));
  }
}

void Ground::Join() {
  if (job_.valid()) job_.get();
  for (const NodeSinkage& compaction : job_result_.compaction) surface_.SetCompaction(compaction);
  job_result_.energy.resize(work_.size());
  for (std::size_t source = 0; source < work_.size(); ++source) {
    work_[source].energy += job_result_.energy[source];
    work_[source].power = job_period_ > 0 ? job_result_.energy[source] / job_period_ : 0.0;
  }
  lowest_volume_yields_ = lowest_volume_yields_ || job_result_.lowest_volume_yields;
  job_result_ = PeriodResult{};
}

std::size_t Ground::VolumeCount() {
  if (job_.valid()) job_.wait();
  return columns_.volume_count();
}

std::size_t Ground::ColumnCount() {
  if (job_.valid()) job_.wait();
  return columns_.column_count();
}

std::size_t Ground::ColumnBytes() {
  if (job_.valid()) job_.wait();
  return columns_.MemoryBytes() + surface_.MemoryBytes();
}

std::size_t Ground::VolumeBytes() {
  if (job_.valid()) job_.wait();
  return columns_.VolumeBytes();
}

}  // namespace softsoil
