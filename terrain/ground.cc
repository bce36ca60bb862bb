#include "terrain/ground.h"

#include <utility>

#include "terrain/worker_pool.h"

namespace softsoil {
namespace {

constexpr double kMostPressure = 1e8;  // [Pa]  that a state may have on the ground

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
    : soil_(std::make_shared<Soil>(soil)),
      settings_(Checked(settings)),
      surface_(settings.grid_spacing, settings.mode, undisturbed),
      columns_(soil, {settings.grid_spacing, settings.volume_height, settings.volumes}, undisturbed,
               MakeDirectStress({soil.concentration_factor,
                                 kNearFieldSpacings * settings.grid_spacing, settings.threads})),
      clock_(settings.soil_clock),
      work_(sources) {
  for (int source = 0; source < sources; ++source) gatherers_.emplace_back(settings.grid_spacing);
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
  WorkerPool& pool = WorkerPool::Shared();
  const auto job = std::make_shared<Job>();
  job->load = std::move(load);
  job->period = period;
  const auto advance = [job] {
    try {
      job->result = job->columns.Advance(job->load, job->period);
    } catch (...) {
      job->failure = std::current_exception();
    }
  };
  job->columns = std::move(columns_);
  try {
    job_done_ = pool.Run(advance).share();
  } catch (...) {
    columns_ = std::move(job->columns);
    throw;
  }
  job_ = job;
}

void Ground::Join() {
  if (job_ == nullptr) return;
  job_done_.wait();
  // Should memory run out here, the next Join() does it again.
  for (const NodeSinkage& c : job_->result.compaction) surface_.SetCompaction(c);
  columns_ = job_->columns;
  column_bytes_copied_ = columns_.BytesCopied();
  const std::shared_ptr<const Job> job = std::exchange(job_, nullptr);
  if (job->failure != nullptr) std::rethrow_exception(job->failure);
  CountWork(job->result, job->period);
}

void Ground::CountWork(const PeriodResult& result, double period) {
  for (std::size_t source = 0; source < work_.size(); ++source) {
    const double energy = source < result.energy.size() ? result.energy[source] : 0.0;
    work_[source].energy += energy;
    work_[source].power = energy / period;
  }
  lowest_volume_yields_ = lowest_volume_yields_ || result.lowest_volume_yields;
}

const Columns& Ground::LatestColumns() const {
  if (job_ == nullptr) return columns_;
  job_done_.wait();
  return job_->columns;
}

std::size_t Ground::VolumeCount() const { return LatestColumns().volume_count(); }

std::size_t Ground::ColumnCount() const { return LatestColumns().column_count(); }

std::size_t Ground::ColumnBytes() const {
  return LatestColumns().MemoryBytes() + surface_.MemoryBytes();
}

std::size_t Ground::VolumeBytes() const { return LatestColumns().VolumeBytes(); }

std::size_t Ground::BytesCopied() const {
  std::size_t bytes = surface_.BytesCopied() + column_bytes_copied_;
  for (const LoadGatherer& gatherer : gatherers_) bytes += gatherer.BytesCopied();
  return bytes;
}

void Ground::Write(StateWriter& writer) const {
  const Columns& columns = LatestColumns();  // waits
  if (job_ != nullptr && job_->failure != nullptr) std::rethrow_exception(job_->failure);
  surface_.Write(writer);
  columns.Write(writer);
  clock_.Write(writer);
  for (const LoadGatherer& gatherer : gatherers_) gatherer.Write(writer);
  for (const CompactionWork& work : work_) {
    writer.Put(work.energy);
    writer.Put(work.power);
  }
  writer.Put(lowest_volume_yields_);
  writer.Put(job_ != nullptr);
  if (job_ == nullptr) return;
  writer.Put(job_->period);
  softsoil::Write(job_->result, writer);
}

void Ground::Read(StateReader& reader) {
  surface_.Read(reader);
  columns_.Read(reader);
  clock_.Read(reader);
  const double area = settings_.grid_spacing * settings_.grid_spacing;
  const double most = kMostPressure * area * settings_.soil_clock;
  for (LoadGatherer& gatherer : gatherers_) gatherer.Read(reader, most);
  for (CompactionWork& work : work_) {
    work.energy = reader.GetFinite();
    work.power = reader.GetFinite();
  }
  lowest_volume_yields_ = reader.GetFlag();
  if (!reader.GetFlag()) return;
  const double period = reader.GetFinite();
  reader.Require(period > 0, "a soil period");
  job_ = std::make_shared<Job>();
  job_->period = period;
  job_->result = ReadPeriodResult(reader);
  job_->columns = std::move(columns_);
  std::promise<void> done;
  job_done_ = done.get_future().share();
  done.set_value();
}

}  // namespace softsoil
