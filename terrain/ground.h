// Soft ground as a vehicle meets it: a surface that gives way, and the soil below that is updated
// on the soil clock.
#pragma once

#include <future>
#include <memory>
#include <vector>

#include "terrain/columns.h"
#include "terrain/compacted_surface.h"
#include "terrain/limits.h"
#include "terrain/soil_clock.h"
#include "terrain/soil_flow.h"
#include "terrain/soil_map.h"
#include "terrain/surface.h"
#include "terrain/surface_load.h"
#include "terrain/wall_times.h"

namespace softsoil {

constexpr Limits kGridSpacingLimits = {0.001, 10};   // [m]
constexpr Limits kVolumeHeightLimits = {0.001, 10};  // [m]
constexpr Limits kVolumesLimits = {1, 1000};         // [-]
constexpr Limits kSoilClockLimits = {0.0001, 10};    // [s]
constexpr Limits kThreadsLimits = {1, 1024};         // [-]

struct GroundSettings {
  double grid_spacing = 0.025;   // [m]
  double volume_height = 0.025;  // [m]
  int volumes = 30;              // [-]  per column
  double soil_clock = 0.01;      // [s]  simulated time between soil updates
  bool sync = false;             // wait for the update at the tick, instead of one tick later
  SurfaceMode mode = SurfaceMode::kFlow;
  int threads = 1;  // of the stress field, at most
  StressBackend stress = StressBackend::kDirect;
};

// Soil updates with load by the backend of their stress field, since the object was made.
struct StressUpdates {
  std::size_t direct = 0, gaussian = 0;
};

// Compaction work that a source has done.
struct CompactionWork {
  double energy = 0;  // [J]  since the start
  double power = 0;   // [W]  mean of the last soil period
};

// A copy is a second ground that from now on goes its own way. It costs next to nothing: what has
// not changed since is shared, a soil update in flight too.
class Ground {
 public:
  // Throws InputError if a setting is out of range.
  Ground(const SoilMap& soils, const GroundSettings& settings, UndisturbedHeight undisturbed,
         int sources);

  const SoilMap& soils() const { return soils_; }
  const GroundSettings& settings() const { return settings_; }
  const Surface& surface() const { return surface_; }

  // History. Forces [N] of one source that acted on the ground for h [s], the slip sinkage that
  // they brought about, and the depth below the undisturbed ground to which it pressed the soil at
  // some nodes. The surface yields to the latter at once; soil that is pushed away comes to lie
  // elsewhere at the next tick of the soil clock.
  // Neither can fail after Reserve() with the same, which changes nothing else.
  void Reserve(int source, const std::vector<SurfaceForce>& forces,
               const std::vector<NodeSinkage>& depths);
  void AddLoad(int source, const std::vector<SurfaceForce>& forces, double h);
  void DeepenPlastic(int source, const std::vector<NodeSinkage>& depths);

  // Lets h [s] of simulated time pass. At a tick of the soil clock the job of the tick before is
  // awaited, its heights become the surface, displaced soil moves, and the mean load of the period
  // is handed to the next job; with `sync` that job is done first and awaited, so that its heights
  // become the surface without lag. If memory runs out, or a job throws, the surface stays as it
  // is, the tick is put off to the next call and nothing is lost: a job that failed is done again
  // by whoever waits for it.
  void Pass(double h);

  // Of the heights that are in the surface; a job in flight is not counted.
  const CompactionWork& Work(int source) const { return work_[source]; }
  bool LowestVolumeYields() const { return lowest_volume_yields_; }
  const StressUpdates& stress_updates() const { return stress_updates_; }
  // [m^3]  displaced since the last tick: DisplacedVolume() = MovedVolume() + VolumeInHand().
  double VolumeInHand() const;
  // These wait for the job in flight.
  std::size_t VolumeCount() const;
  std::size_t ColumnCount() const;
  std::size_t ColumnBytes() const;  // of columns, volumes and surface
  std::size_t VolumeBytes() const;  // part of it that grows with the number of volumes

  // Of this ground and its copies.
  WallTimes& Times() const { return *times_; }

  // Bytes of soil that had to be copied so far because other copies shared them; of the columns as
  // of the last job that was awaited. And what no copy shares, but for the columns.
  std::size_t BytesCopied() const;
  std::size_t OwnBytes() const;

  // All that the future depends on. Write() waits for the job in flight.
  // Read() is for a ground as just made; it throws InputError, and then the ground is of no use.
  void Write(StateWriter& writer) const;
  void Read(StateReader& reader);

 private:
  // A soil update. It holds all that it works on, so that it needs none of the copies of the ground
  // that wait for it.
  struct Job {
    SurfaceLoad load;
    double period;    // [s]
    bool keeps_load;  // once done: with `sync`, for the soil that moves when the surface sinks
    std::shared_ptr<WallTimes> times;
    Columns columns = {};
    PeriodResult result = {};
    bool is_done = false;  // else there is no result yet, and columns are as they were

    void Do();
  };

  // What a tick changes, but for the next job.
  struct Tick {
    std::shared_ptr<const Job> done;  // whose result becomes the surface; null: none
    Columns columns;
    SoilFlow::Step flow;
  };

  // These may fail, and change nothing that can be asked.
  SurfaceLoad MeanLoad(const CompactedSurface& surface) const;
  std::shared_ptr<Job> MakeJob(const Job* done) const;  // for the surface once `done` is in it
  std::shared_ptr<const Job> DoneJob() const;           // the job in flight, if any; done
  Tick Prepare(std::shared_ptr<const Job> done, const SurfaceLoad& load);
  CompactedSurface SurfaceAfter(const Job* done) const;
  // These cannot fail.
  void Finish(Tick tick);
  void Start(std::shared_ptr<Job> job);

  void JoinInSync();
  void CountWork(const PeriodResult& result, double period);
  const Columns& LatestColumns() const;

  SoilMap soils_;
  GroundSettings settings_;
  Surface surface_;
  Columns columns_;
  SoilClock clock_;
  SoilFlow flow_;
  std::vector<LoadGatherer> gatherers_;  // by source
  std::vector<CompactionWork> work_;     // by source
  bool lowest_volume_yields_ = false;
  StressUpdates stress_updates_;
  std::size_t column_bytes_copied_ = 0;
  std::shared_ptr<WallTimes> times_ = std::make_shared<WallTimes>();

  // The job in flight, which has the columns meanwhile; null if none.
  std::shared_ptr<Job> job_;
  std::shared_future<void> job_done_;
};

}  // namespace softsoil
