#include "terrain/surface_load.h"

#include <cmath>

#include "terrain/surface.h"

namespace softsoil {

void Write(const SurfaceLoad& load, StateWriter& writer) {
  writer.Put(static_cast<std::uint64_t>(load.size()));
  for (const NodeForce& f : load) {
    writer.Put(f.node);
    for (const double value : {f.x, f.y, f.z}) writer.Put(value);
    writer.PutBytes(f.force_w.data(), sizeof f.force_w);
    writer.Put(f.source);
  }
}

SurfaceLoad ReadSurfaceLoad(StateReader& reader, int sources, double most) {
  constexpr std::size_t kBytes = sizeof(GridNode) + 6 * sizeof(double) + sizeof(int);
  SurfaceLoad load(reader.Count(kBytes));
  for (NodeForce& f : load) {
    f.node = reader.Get<GridNode>();
    for (double* value : {&f.x, &f.y, &f.z}) *value = reader.GetFinite();
    reader.GetFinite(f.force_w.data(), 3);
    f.source = reader.Get<int>();
    reader.Require(IsOnGrid(TileOf(f.node)), "a node of the load");
    reader.Require(Eigen::Vector3d(f.x, f.y, f.z).cwiseAbs().maxCoeff() <= kFarthest,
                   "the place of a load");
    reader.Require(f.force_w.cwiseAbs().maxCoeff() <= most, "a load");
    reader.Require(f.source >= 0 && f.source < sources, "the source of a load");
  }
  return load;
}

CellShares::CellShares(const Eigen::Vector3d& point_w, double spacing) {
  const double gx = point_w.x() / spacing, gy = point_w.y() / spacing;
  const double i = std::floor(gx), j = std::floor(gy);
  node_ = {static_cast<int>(i), static_cast<int>(j)};
  u_ = gx - i;
  v_ = gy - j;
}

void LoadGatherer::Add(const SurfaceForce& force, double h) {
  const Eigen::Vector3d impulse = h * force.force_w;
  CellShares(force.point_w, spacing_).ForEach([&](GridNode node, double share) {
    At(node) += share * impulse;
  });
}

void LoadGatherer::Reserve(const std::vector<SurfaceForce>& forces) {
  for (const SurfaceForce& force : forces) {
    CellShares(force.point_w, spacing_).ForEach([&](GridNode node, double) { At(node); });
  }
}

void LoadGatherer::Write(StateWriter& writer) const {
  const auto impulses = impulses_.InOrder();
  writer.Put(static_cast<std::uint64_t>(impulses.size()));
  for (const auto& [node, impulse_w] : impulses) {
    writer.Put(node);
    writer.PutBytes(impulse_w.data(), sizeof impulse_w);
  }
}

void LoadGatherer::Read(StateReader& reader, double most) {
  impulses_.Read(reader, 3 * sizeof(double), [most](StateReader& from) {
    Eigen::Vector3d impulse_w;
    from.GetFinite(impulse_w.data(), 3);
    from.Require(impulse_w.cwiseAbs().maxCoeff() <= most, "an impulse on the ground");
    return impulse_w;
  });
}

}  // namespace softsoil
