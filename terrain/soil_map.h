// Which soil lies where: one everywhere, and others in regions of it.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "terrain/soil.h"

namespace softsoil {

// A parallelogram of the x, y plane: a rectangle that lies on the ground, as seen from above.
struct SoilRegion {
  Soil soil;
  Eigen::Vector2d centre;      // [m]
  Eigen::Matrix2d half_sides;  // [m]  columns: from the centre to the middles of two sides
};

// Copies share all.
class SoilMap {
 public:
  SoilMap() = default;  // of no ground; to be assigned to
  // Soil as far as the ground reaches; later regions lie on earlier ones. Throws InputError if a
  // region has no area.
  SoilMap(const Soil& everywhere, const std::vector<SoilRegion>& regions = {});

  // Soils are numbered: 0 is that beyond all regions, k + 1 that of the region k.
  int size() const { return static_cast<int>(data_->regions.size()) + 1; }
  const Soil& operator[](int number) const {
    return number == 0 ? data_->everywhere : data_->regions[number - 1].soil;
  }
  int NumberAt(double x, double y) const { return size() == 1 ? 0 : NumberInRegions(x, y); }
  const Soil& At(double x, double y) const { return (*this)[NumberAt(x, y)]; }

  const std::vector<SoilRegion>& regions() const { return data_->regions; }

 private:
  struct Data {
    Soil everywhere;
    std::vector<SoilRegion> regions;
    std::vector<Eigen::Matrix2d> to_unit;  // of each region, to the square from -1 to 1
  };
  int NumberInRegions(double x, double y) const;

  std::shared_ptr<const Data> data_;
};

}  // namespace softsoil
