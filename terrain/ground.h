// Soft ground as a vehicle meets it: a surface that gives way, and the soil below that is updated
// on the soil clock.
#pragma once

#include <future>
#include <memory>
#include <vector>

#include "terrain/columns.h"
#include "terrain/limits.h"
#include "terrain/soil.h"
#include "terrain/soil_clock.h"
#include "terrain/surface.h"
#include "terrain/surface_load.h"

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
  bool sync = false;             // update in place at the tick, instead of in the background
  SurfaceMode mode = SurfaceMode::kFlow;
  int threads = 1;  // of the stress field
};

// Compaction work that a source has done.
struct CompactionWork {
  double energy = 0;  // [J]  since the start
  double power = 0;   // [W]  mean of the last soil period
};

class Ground {
 public:
  // Throws InputError if a setting is out of range.
  Ground(const Soil& soil, const GroundSettings& settings, UndisturbedHeight undisturbed,
         int sources);
  ~Ground();
  Ground(const Ground&) = delete;
  Ground& operator=(const Ground&) = delete;

  const Soil& soil() const { return soil_; }
  const GroundSettings& settings() const { return settings_; }
  const Surface& surface() const { return surface_; }

  // History. Forces [N] of one source that acted on the ground for h [s], and the bearing sinkage
  // it reached. The surface yields to the latter at once.
  void AddLoad(int source, const std::vector<SurfaceForce>& forces, double h);
  void DeepenPlastic(const std::vector<NodeSinkage>& plastic);

  // Lets h [s] of simulated time pass. At a tick of the soil clock the job of the tick before is
  // awaited, its heights become the surface, and the mean load of the period is handed to the
  // next job; with `sync` that job runs at once and its heights become the surface without lag.
  void Pass(double h);

  // Of the heights that are in the surface; a job in flight is not counted.
  const CompactionWork& Work(int source) const { return work_[source]; }
  bool LowestVolumeYields() const { return lowest_volume_yields_; }
  // Waits for the job in flight, then tells the size of the soil.
  std::size_t VolumeCount();
  std::size_t ColumnCount();
  std::size_t ColumnBytes();  // of columns, volumes and surface
  std::size_t VolumeBytes();  // part of it that grows with the number of volumes

 private:
  SurfaceLoad TakeLoad(double period);
  void Start(SurfaceLoad load, double period);
  void Join();

  Soil soil_;
  GroundSettings settings_;
  Surface surface_;
  Columns columns_;
  SoilClock clock_;
  std::vector<LoadGatherer> gatherers_;  // by source
  std::vector<CompactionWork> work_;     // by source
  bool lowest_volume_yields_ = false;

  std::future<void> job_;
  PeriodResult job_result_;  // written by the job, read after it is joined
  double job_period_ = 0;    // [s]
};

}  // namespace softsoil
