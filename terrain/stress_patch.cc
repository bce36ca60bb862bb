#include "terrain/stress_patch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace softsoil {
namespace {

struct Place {
  int i, j, column;
};

StressPatch MakePatch(const ColumnBatch& batch, const std::vector<Place>& places) {
  StressPatch patch{};
  patch.i0 = places.front().i;
  patch.j0 = places.front().j;
  int i1 = patch.i0, j1 = patch.j0;
  patch.top = patch.bottom = batch.z[std::size_t(places.front().column) * batch.volumes];
  for (const Place& p : places) {
    patch.i0 = std::min(patch.i0, p.i);
    patch.j0 = std::min(patch.j0, p.j);
    i1 = std::max(i1, p.i);
    j1 = std::max(j1, p.j);
    const double* z = &batch.z[std::size_t(p.column) * batch.volumes];
    patch.top = std::max(patch.top, z[0]);
    patch.bottom = std::min(patch.bottom, z[batch.volumes - 1]);
  }
  patch.nx = i1 - patch.i0 + 1;
  patch.ny = (j1 - patch.j0 + kSumLanes) / kSumLanes * kSumLanes;
  patch.column.assign(std::size_t(patch.nx) * patch.ny, -1);
  for (const Place& p : places) {
    patch.column[(p.i - patch.i0) * patch.ny + p.j - patch.j0] = p.column;
  }
  return patch;
}

int SquareOf(int node) {
  return static_cast<int>(std::floor(static_cast<double>(node) / kPatchSide));
}

}  // namespace

std::vector<StressPatch> MakePatches(const ColumnBatch& batch, const std::vector<int>& law_of_soil,
                                     double spacing) {
  using Key = std::array<int, 3>;  // law and square
  std::map<Key, std::vector<Place>> places;
  std::vector<Place>* latest = nullptr;  // columns next to each other come one after the other
  Key latest_key{};
  for (std::size_t column = 0; column < batch.columns(); ++column) {
    const int i = static_cast<int>(std::lround(batch.x[column] / spacing));
    const int j = static_cast<int>(std::lround(batch.y[column] / spacing));
    const Key key{law_of_soil[batch.soil[column]], SquareOf(i), SquareOf(j)};
    if (latest == nullptr || key != latest_key) latest = &places[key];
    latest_key = key;
    latest->push_back({i, j, static_cast<int>(column)});
  }
  std::vector<StressPatch> patches;
  for (const auto& [key, columns] : places) {
    patches.push_back(MakePatch(batch, columns));
    patches.back().law = key[0];
  }
  return patches;
}

}  // namespace softsoil
