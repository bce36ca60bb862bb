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

std::vector<double> ConcentrationFactors(const SoilMap& soils) {
  std::vector<double> factors;
  for (int k = 0; k < soils.size(); ++k) factors.push_back(soils[k].concentration_factor);
  return factors;
}

}  // namespace

Ground::Ground(const SoilMap& soils, const GroundSettings& settings, UndisturbedHeight undisturbed,
               int sources)
    : soils_(soils),
      settings_(Checked(settings)),
      surface_(settings.grid_spacing, settings.mode, undisturbed),
      columns_(soils, {settings.grid_spacing, settings.volume_height, settings.volumes},
               undisturbed,
               MakeStressField(settings.stress,
                               {ConcentrationFactors(soils),
                                kNearFieldSpacings * settings.grid_spacing, settings.threads},
                               settings.grid_spacing)),
      clock_(settings.soil_clock),
      flow_(soils, settings.grid_spacing, sources),
      work_(sources) {
  for (int source = 0; source < sources; ++source) gatherers_.emplace_back(settings.grid_spacing);
}

void Ground::AddLoad(int source, const std::vector<SurfaceForce>& forces, double h) {
  const double area = settings_.grid_spacing * settings_.grid_spacing;
  for (const SurfaceForce& force : forces) {
    gatherers_[source].Add(force, h);
    if (force.slip_volume <= 0) continue;
    const CellShares shares(force.point_w, settings_.grid_spacing);
    shares.ForEach([&](GridNode node, double share) {
      surface_.AddSlipSinkage({node, share * force.slip_volume / area});
    });
  }
}

void Ground::Reserve(int source, const std::vector<SurfaceForce>& forces,
                     const std::vector<NodeSinkage>& depths) {
  gatherers_[source].Reserve(forces);
  surface_.ReservePlastic(depths);
  for (const SurfaceForce& force : forces) {
    if (force.slip_volume <= 0) continue;
    const CellShares shares(force.point_w, settings_.grid_spacing);
    shares.ForEach([&](GridNode node, double) { surface_.ReserveSlipSinkage(node); });
  }
  flow_.Reserve(source, depths);
}

void Ground::DeepenPlastic(int source, const std::vector<NodeSinkage>& depths) {
  for (const NodeSinkage& depth : depths) {
    const double pushed = surface_.DeepenPlastic(depth);
    if (pushed > 0) flow_.Push(source, {depth.node, pushed});
  }
}

void Ground::Pass(double h) {
  const bool is_tick = clock_.Pass(h);
  if (settings_.sync) {
    JoinInSync();  // if it was put off
    if (!is_tick) return;
    Start(MakeJob(nullptr));
    JoinInSync();
  } else if (is_tick) {
    auto done = DoneJob();
    auto next = MakeJob(done.get());
    Finish(Prepare(std::move(done), next->load));
    Start(std::move(next));
  }
}

void Ground::JoinInSync() {
  if (job_ != nullptr) Finish(Prepare(DoneJob(), job_->load));
}

CompactedSurface Ground::SurfaceAfter(const Job* done) const {
  if (done == nullptr) return surface_;
  return {surface_, done->result.compaction};
}

SurfaceLoad Ground::MeanLoad(const CompactedSurface& surface) const {
  SurfaceLoad load;
  const auto height = [&](GridNode node) { return surface.Height(node); };
  for (std::size_t source = 0; source < gatherers_.size(); ++source) {
    gatherers_[source].AddMean(static_cast<int>(source), clock_.Elapsed(), height, &load);
  }
  return load;
}

std::shared_ptr<Ground::Job> Ground::MakeJob(const Job* done) const {
  return std::make_shared<Job>(
      Job{MeanLoad(SurfaceAfter(done)), clock_.Elapsed(), settings_.sync, times_});
}

Ground::Tick Ground::Prepare(std::shared_ptr<const Job> done, const SurfaceLoad& load) {
  Tick tick;
  const Stopwatch stopwatch(times_.get(), Work::kFlow);
  tick.flow = flow_.Tick(SurfaceAfter(done.get()), load);
  if (done != nullptr) {
    tick.columns = done->columns;
    surface_.ReserveCompaction(done->result.compaction);
  }
  surface_.ReserveMoved(tick.flow.moved);
  tick.done = std::move(done);
  return tick;
}

void Ground::Finish(Tick tick) {
  const Stopwatch stopwatch(times_.get(), Work::kFlow);
  if (tick.done != nullptr) {
    for (const NodeSinkage& c : tick.done->result.compaction) surface_.SetCompaction(c);
    columns_ = std::move(tick.columns);
    column_bytes_copied_ = columns_.BytesCopied();
    CountWork(tick.done->result, tick.done->period);
    job_ = nullptr;
  }
  for (const NodeSoil& moved : tick.flow.moved) surface_.SetMoved(moved);
  flow_.Finish(std::move(tick.flow));
}

void Ground::Job::Do() {
  result = columns.Advance(load, period, times.get());
  if (!keeps_load) load = {};  // copies of the ground may hold the job for long
  is_done = true;
}

void Ground::Start(std::shared_ptr<Job> job) {
  job->columns = std::move(columns_);  // so that it shares no tile with this ground
  for (LoadGatherer& gatherer : gatherers_) gatherer.Clear();
  clock_.Restart();
  job_ = job;
  job_done_ = {};
  // Whatever fails here is tried again, and told, by DoneJob().
  try {
    job_done_ = WorkerPool::Shared()
                    .Run([job = std::move(job)]() mutable {
                      const auto mine = std::move(job);  // job_done_ holds this function for long
                      mine->Do();
                    })
                    .share();
  } catch (...) {
  }
}

std::shared_ptr<const Ground::Job> Ground::DoneJob() const {
  if (job_ == nullptr) return nullptr;
  const Stopwatch stopwatch(times_.get(), Work::kWaiting);
  if (job_done_.valid()) job_done_.wait();
  if (job_->is_done) return job_;
  const auto again = std::make_shared<Job>(*job_);
  again->Do();
  return again;
}

void Ground::CountWork(const PeriodResult& result, double period) {
  for (std::size_t source = 0; source < work_.size(); ++source) {
    const double energy = source < result.energy.size() ? result.energy[source] : 0.0;
    work_[source].energy += energy;
    work_[source].power = energy / period;
  }
  lowest_volume_yields_ = lowest_volume_yields_ || result.lowest_volume_yields;
  if (result.stress_backend == StressBackend::kDirect) ++stress_updates_.direct;
  if (result.stress_backend == StressBackend::kGaussian) ++stress_updates_.gaussian;
}

const Columns& Ground::LatestColumns() const {
  if (job_ == nullptr) return columns_;
  if (job_done_.valid()) job_done_.wait();
  return job_->columns;
}

std::size_t Ground::VolumeCount() const { return LatestColumns().volume_count(); }

std::size_t Ground::ColumnCount() const { return LatestColumns().column_count(); }

std::size_t Ground::ColumnBytes() const {
  return LatestColumns().MemoryBytes() + surface_.MemoryBytes();
}

std::size_t Ground::VolumeBytes() const { return LatestColumns().VolumeBytes(); }

std::size_t Ground::BytesCopied() const { return surface_.BytesCopied() + column_bytes_copied_; }

std::size_t Ground::OwnBytes() const {
  std::size_t bytes = 0;
  for (const LoadGatherer& gatherer : gatherers_) bytes += sizeof gatherer + gatherer.MemoryBytes();
  return bytes + flow_.MemoryBytes() + work_.size() * sizeof work_.front();
}

double Ground::VolumeInHand() const {
  return flow_.InHand() * settings_.grid_spacing * settings_.grid_spacing;
}

void Ground::Write(StateWriter& writer) const {
  std::shared_ptr<const Job> job = job_;
  try {
    job = DoneJob();
  } catch (...) {  // then it is written as one that is still to be done
  }
  surface_.Write(writer);
  flow_.Write(writer);
  (job != nullptr ? job->columns : columns_).Write(writer);
  clock_.Write(writer);
  for (const LoadGatherer& gatherer : gatherers_) gatherer.Write(writer);
  for (const CompactionWork& work : work_) {
    writer.Put(work.energy);
    writer.Put(work.power);
  }
  writer.Put(lowest_volume_yields_);
  writer.Put(job != nullptr);
  if (job == nullptr) return;
  writer.Put(job->period);
  softsoil::Write(job->load, writer);
  writer.Put(job->is_done);
  if (job->is_done) softsoil::Write(job->result, writer);
}

void Ground::Read(StateReader& reader) {
  surface_.Read(reader);
  flow_.Read(reader);
  columns_.Read(reader);
  clock_.Read(reader);
  const double area = settings_.grid_spacing * settings_.grid_spacing;
  const double most = kMostPressure * area * clock_.Elapsed();
  for (LoadGatherer& gatherer : gatherers_) gatherer.Read(reader, most);
  for (CompactionWork& work : work_) {
    work.energy = reader.GetFinite();
    work.power = reader.GetFinite();
  }
  lowest_volume_yields_ = reader.GetFlag();
  if (!reader.GetFlag()) return;
  const double period = reader.GetFinite();
  reader.Require(clock_.IsFullAt(period), "a soil period");
  const int sources = static_cast<int>(gatherers_.size());
  SurfaceLoad load = ReadSurfaceLoad(reader, sources, kMostPressure * area);
  const auto job = std::make_shared<Job>(Job{std::move(load), period, settings_.sync, times_});
  job->columns = std::move(columns_);
  job->is_done = reader.GetFlag();
  if (job->is_done) job->result = ReadPeriodResult(reader);
  job_ = job;
}

}  // namespace softsoil
