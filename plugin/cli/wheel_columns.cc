#include "plugin/cli/wheel_columns.h"

#include <algorithm>

#include "terrain/constants.h"

namespace softsoil {
namespace {

using Wheel = softsoilWheel;

}  // namespace

const std::vector<WheelColumn>& WheelColumns() {
  static const std::vector<WheelColumn> columns = {
      {"x", "m", 1, false, [](const Wheel& w) { return w.centre[0]; }},
      {"y", "m", 1, false, [](const Wheel& w) { return w.centre[1]; }},
      {"z", "m", 1, false, [](const Wheel& w) { return w.centre[2]; }},
      {"load", "N", 1, true, [](const Wheel& w) { return w.load; }},
      {"sinkage", "m", 1, true, [](const Wheel& w) { return w.sinkage; }},
      {"rut_depth", "m", 1, true, [](const Wheel& w) { return w.rut_depth; }},
      {"slip_ratio", "-", 1, true, [](const Wheel& w) { return w.slip_ratio; }},
      {"slip_angle", "deg", kDegrees, true, [](const Wheel& w) { return w.slip_angle; }},
      {"camber", "deg", kDegrees, true, [](const Wheel& w) { return w.camber; }},
      {"spin", "rad/s", 1, true, [](const Wheel& w) { return w.spin; }},
      {"forward_speed", "m/s", 1, true, [](const Wheel& w) { return w.forward_speed; }},
      {"thrust", "N", 1, true, [](const Wheel& w) { return w.thrust; }},
      {"motion_resistance", "N", 1, true, [](const Wheel& w) { return w.motion_resistance; }},
      {"drawbar_pull", "N", 1, true, [](const Wheel& w) { return w.drawbar_pull; }},
      {"lateral_force", "N", 1, true, [](const Wheel& w) { return w.lateral_force; }},
      {"torque", "N m", 1, true, [](const Wheel& w) { return w.torque; }},
      {"contact_area", "m^2", 1, true, [](const Wheel& w) { return w.contact_area; }},
      {"mean_pressure", "Pa", 1, true, [](const Wheel& w) { return w.mean_pressure; }},
      {"peak_pressure", "Pa", 1, true, [](const Wheel& w) { return w.peak_pressure; }},
      {"compaction_energy", "J", 1, false, [](const Wheel& w) { return w.compaction_energy; }},
      {"compaction_power", "W", 1, true, [](const Wheel& w) { return w.compaction_power; }},
  };
  return columns;
}

std::string KeyOf(const WheelColumn& column) {
  const bool degrees = std::string(column.unit) == "deg";
  return std::string(column.name) + (degrees ? "_deg" : "");
}

void WheelMean::Add(const softsoilWheel& wheel) {
  const std::vector<WheelColumn>& columns = WheelColumns();
  sums_.resize(columns.size());
  last_.resize(columns.size());
  for (std::size_t c = 0; c < columns.size(); ++c) {
    last_[c] = columns[c].value(wheel) * columns[c].from_si;
    sums_[c] += last_[c];
  }
  ++count_;
}

std::vector<double> WheelMean::Values() const {
  const std::vector<WheelColumn>& columns = WheelColumns();
  if (count_ == 0) return std::vector<double>(columns.size());
  std::vector<double> values = last_;
  for (std::size_t c = 0; c < columns.size(); ++c) {
    if (columns[c].averaged) values[c] = sums_[c] / count_;
  }
  return values;
}

double WheelMean::Value(const std::string& key) const {
  const std::vector<WheelColumn>& columns = WheelColumns();
  const auto it = std::find_if(columns.begin(), columns.end(),
                               [&key](const WheelColumn& c) { return KeyOf(c) == key; });
  return Values().at(it - columns.begin());
}

}  // namespace softsoil
