#include "terrain/stress_patch.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace softsoil {
namespace {

struct Place {
  int i, j, column;
};

using Places = std::vector<Place>;

// A rectangle of nodes, i1 and j1 inside.
struct Box {
  int i0, i1, j0, j1;
  int nx() const { return i1 - i0 + 1; }
  int ny() const { return j1 - j0 + 1; }
};

Box BoxAround(Places::const_iterator begin, Places::const_iterator end) {
  Box box{begin->i, begin->i, begin->j, begin->j};
  for (auto p = begin; p != end; ++p) {
    box.i0 = std::min(box.i0, p->i);
    box.i1 = std::max(box.i1, p->i);
    box.j0 = std::min(box.j0, p->j);
    box.j1 = std::max(box.j1, p->j);
  }
  return box;
}

StressPatch MakePatch(const ColumnBatch& batch, const Box& box, Places::const_iterator begin,
                      Places::const_iterator end) {
  StressPatch patch{};
  patch.i0 = box.i0;
  patch.j0 = box.j0;
  patch.nx = box.nx();
  patch.ny = InSumLanes(box.ny());
  patch.column.assign(std::size_t(patch.nx) * patch.ny, -1);
  patch.top = patch.bottom = batch.z[std::size_t(begin->column) * batch.volumes];
  for (auto p = begin; p != end; ++p) {
    patch.column[std::size_t(p->i - box.i0) * patch.ny + p->j - box.j0] = p->column;
    const double* z = &batch.z[std::size_t(p->column) * batch.volumes];
    patch.top = std::max(patch.top, z[0]);
    patch.bottom = std::min(patch.bottom, z[batch.volumes - 1]);
  }
  return patch;
}

// Halves a rectangle across its longer side until it is small and full enough.
void Divide(const ColumnBatch& batch, Places::iterator begin, Places::iterator end,
            std::vector<StressPatch>* patches) {
  if (begin == end) return;
  const Box box = BoxAround(begin, end);
  const double nodes = double(box.nx()) * box.ny();
  const bool is_small = std::max(box.nx(), box.ny()) <= kPatchSide;
  if (is_small && static_cast<double>(end - begin) >= kPatchFill * nodes) {
    patches->push_back(MakePatch(batch, box, begin, end));
    return;
  }
  const auto is_first_half = [&](const Place& p) {
    return box.nx() > box.ny() ? p.i - box.i0 < box.nx() / 2 : p.j - box.j0 < box.ny() / 2;
  };
  const auto middle = std::partition(begin, end, is_first_half);
  Divide(batch, begin, middle, patches);
  Divide(batch, middle, end, patches);
}

}  // namespace

std::vector<StressPatch> MakePatches(const ColumnBatch& batch, const std::vector<int>& law_of_soil,
                                     double spacing) {
  std::map<int, Places> places;  // by law
  for (std::size_t column = 0; column < batch.columns(); ++column) {
    places[law_of_soil[batch.soil[column]]].push_back(
        {static_cast<int>(std::lround(batch.x[column] / spacing)),
         static_cast<int>(std::lround(batch.y[column] / spacing)), static_cast<int>(column)});
  }
  std::vector<StressPatch> patches;
  for (auto& [law, columns] : places) {
    const std::size_t first = patches.size();
    Divide(batch, columns.begin(), columns.end(), &patches);
    for (std::size_t k = first; k < patches.size(); ++k) patches[k].law = law;
  }
  return patches;
}

}  // namespace softsoil
