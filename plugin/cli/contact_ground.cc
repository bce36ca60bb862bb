#include "plugin/cli/contact_ground.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace softsoil {

double CompactionVolume(const Simulation& simulation, const std::vector<softsoilContact>& contacts,
                        double grid_spacing) {
  struct Span {
    long first, last;
  };
  std::map<long, Span> rows;  // by grid row
  for (const softsoilContact& contact : contacts) {
    const long i = std::lround(contact.position[0] / grid_spacing);
    const long j = std::lround(contact.position[1] / grid_spacing);
    Span& span = rows.emplace(j, Span{i, i}).first->second;
    span = {std::min(span.first, i), std::max(span.last, i)};
  }
  double sinkage = 0;  // [m]  of all nodes
  for (const auto& [j, span] : rows) {
    for (long i = span.first; i <= span.last; ++i) {
      sinkage -= simulation.Height(i * grid_spacing, j * grid_spacing);
    }
  }
  return sinkage * grid_spacing * grid_spacing;
}

}  // namespace softsoil
