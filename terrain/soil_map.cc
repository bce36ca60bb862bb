#include "terrain/soil_map.h"

#include <Eigen/LU>
#include <cmath>

#include "terrain/input_error.h"

namespace softsoil {

SoilMap::SoilMap(const Soil& everywhere, const std::vector<SoilRegion>& regions) {
  const auto data = std::make_shared<Data>();
  data->everywhere = everywhere;
  data->regions = regions;
  for (const SoilRegion& region : regions) {
    const double area = 4 * std::abs(region.half_sides.determinant());
    if (!(area > 0) || !std::isfinite(area) || !region.centre.allFinite()) {
      throw InputError("a region of soil must have a finite area > 0 m^2, got " + Shown(area));
    }
    data->to_unit.push_back(region.half_sides.inverse());
  }
  data_ = data;
}

int SoilMap::NumberInRegions(double x, double y) const {
  for (int k = size() - 1; k > 0; --k) {
    const Eigen::Vector2d from_centre = Eigen::Vector2d(x, y) - data_->regions[k - 1].centre;
    if ((data_->to_unit[k - 1] * from_centre).cwiseAbs().maxCoeff() <= 1) return k;
  }
  return 0;
}

}  // namespace softsoil
